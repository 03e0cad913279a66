// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/pattern/pattern_inspector.h"

#include "widgets/base/theme.h"
#include "widgets/pattern/timeline_menu.h"
#include "widgets/pattern/timeline_painter.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>

namespace teleta::editor {

using namespace pattern;

namespace {

constexpr double kPercent = 100.0;
constexpr std::array kEasings{Easing::linear, Easing::hold, Easing::easeIn, Easing::easeOut,
                              Easing::easeInOut};

} // namespace

PatternInspector::PatternInspector(PatternDocument* document, QWidget* parent)
    : QWidget(parent)
    , m_document(document)
    , m_nameLabel(new QLabel(this))
    , m_durationLabel(new QLabel(this))
    , m_tagsLabel(new QLabel(this))
    , m_notesLabel(new QLabel(this))
    , m_title(new QLabel(this))
    , m_name(new QLineEdit(this))
    , m_duration(new QDoubleSpinBox(this))
    , m_tags(new QLineEdit(this))
    , m_notes(new QPlainTextEdit(this)) {
    m_name->setObjectName(QStringLiteral("name"));
    m_duration->setObjectName(QStringLiteral("duration"));
    m_duration->setRange(0.01, Pattern::kLongest_s);
    m_duration->setDecimals(3);
    m_duration->setSingleStep(0.1);
    m_duration->setKeyboardTracking(false);
    m_tags->setObjectName(QStringLiteral("tags"));
    m_notes->setTabChangesFocus(true);
    m_notes->setFixedHeight(base::em(this, 3.4));
    QFont bold = font();
    bold.setBold(true);
    m_title->setFont(bold);
    auto* form = new QFormLayout;
    form->addRow(m_nameLabel, m_name);
    form->addRow(m_durationLabel, m_duration);
    form->addRow(m_tagsLabel, m_tags);
    form->addRow(m_notesLabel, m_notes);
    auto* inside = new QWidget;
    auto* layout = new QVBoxLayout(inside);
    layout->addLayout(form);
    layout->addWidget(m_title);
    m_rows = new QWidget(inside);
    layout->addWidget(m_rows);
    layout->addStretch(1);
    auto* scroll = new QScrollArea(this);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(inside);
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    outer->addWidget(scroll);

    connect(m_name, &QLineEdit::textEdited, m_document, &PatternDocument::setName);
    connect(m_duration, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        if (!m_showing)
            m_document->setDuration(value);
    });
    connect(m_tags, &QLineEdit::editingFinished, this,
            [this] { m_document->setTags(m_tags->text().split(QLatin1Char(','))); });
    connect(m_notes, &QPlainTextEdit::textChanged, this, [this] {
        if (!m_showing)
            m_document->setNotes(m_notes->toPlainText());
    });
    connect(m_document, &PatternDocument::patternChanged, this, [this] {
        showPattern();
        showSelection();
    });
    connect(m_document, &PatternDocument::selectionChanged, this, &PatternInspector::showSelection);
    showPattern();
    rebuild();
}

void PatternInspector::showPattern() {
    m_showing = true;
    const auto describe = [](QLabel* label, QWidget* box, const QString& text) {
        label->setText(text);
        label->setBuddy(box);
    };
    describe(m_nameLabel, m_name, tr("&Name:"));
    describe(m_durationLabel, m_duration, tr("&Length:"));
    describe(m_tagsLabel, m_tags, tr("&Tags:"));
    describe(m_notesLabel, m_notes, tr("N&otes:"));
    m_duration->setSuffix(QStringLiteral(" s"));
    const Pattern& pattern = m_document->pattern();
    const auto show = [](auto* box, const QString& now, const QString& wanted, auto set) {
        if (now != wanted) // keeps the place of the cursor
            set(box, wanted);
    };
    const auto setText = [](QLineEdit* box, const QString& text) { box->setText(text); };
    show(m_name, m_name->text(), QString::fromStdString(pattern.name), setText);
    QStringList tags;
    for (const std::string& tag : pattern.tags)
        tags << QString::fromStdString(tag);
    show(m_tags, m_tags->text(), tags.join(QStringLiteral(", ")), setText);
    show(m_notes, m_notes->toPlainText(), QString::fromStdString(pattern.notes),
         [](QPlainTextEdit* box, const QString& text) { box->setPlainText(text); });
    m_duration->setValue(pattern.duration_s);
    m_showing = false;
}

void PatternInspector::showSelection() {
    const Selection& selection = m_document->selection();
    QString kind;
    if (selection.object)
        kind = QStringLiteral("object %1").arg(m_document->pattern().objects[*selection.object].form.index());
    else if (!selection.points.empty())
        kind = selection.points.size() == 1 ? QStringLiteral("point") : QStringLiteral("points");
    if (kind != m_kind)
        rebuild();
    m_showing = true;
    if (selection.object)
        m_title->setText(objectText(m_document->pattern().objects[*selection.object]));
    else if (selection.points.empty())
        m_title->setText(tr("Nothing is selected"));
    else if (selection.points.size() == 1)
        m_title->setText(tr("Breakpoint of motor %1").arg(selection.points.front().track + 1));
    else
        m_title->setText(tr("%1 breakpoints").arg(selection.points.size()));
    for (const auto& refresh : m_refresh)
        refresh();
    m_showing = false;
}

void PatternInspector::rebuild() {
    const Selection& selection = m_document->selection();
    m_kind =
        selection.object
            ? QStringLiteral("object %1").arg(m_document->pattern().objects[*selection.object].form.index())
        : selection.points.empty()     ? QString()
        : selection.points.size() == 1 ? QStringLiteral("point")
                                       : QStringLiteral("points");
    m_refresh.clear();
    auto* rows = new QWidget(m_rows->parentWidget());
    m_form = new QFormLayout(rows);
    m_form->setContentsMargins(0, 0, 0, 0);
    m_rows->parentWidget()->layout()->replaceWidget(m_rows, rows);
    m_rows->hide();
    m_rows->deleteLater(); // it may be one of its boxes that has led here
    m_rows = rows;
    if (selection.object)
        buildObject();
    else if (!selection.points.empty())
        buildPoints();
    rows->show();
}

QDoubleSpinBox* PatternInspector::number(const char* name, const QString& label, const QString& unit,
                                         double low, double high, int decimals, std::function<double()> get,
                                         std::function<void(double)> set) {
    auto* box = new QDoubleSpinBox(m_rows);
    box->setObjectName(QLatin1String(name));
    box->setAccessibleName(label);
    box->setRange(low, high);
    box->setDecimals(decimals);
    box->setSingleStep(unit == QLatin1String("s") ? 0.01 : decimals > 1 ? 0.05 : 1.0);
    box->setSuffix(unit.isEmpty() ? QString() : QLatin1Char(' ') + unit);
    box->setKeyboardTracking(false);
    m_form->addRow(label, box);
    connect(box, &QDoubleSpinBox::valueChanged, this, [this, set = std::move(set)](double value) {
        if (!m_showing)
            set(value);
    });
    m_refresh.push_back([box, get = std::move(get)] { box->setValue(get()); });
    return box;
}

void PatternInspector::buildPoints() {
    const auto first = [this]() -> Breakpoint {
        const PointRefs& points = m_document->selection().points;
        return points.empty() ? Breakpoint{}
                              : m_document->pattern().tracks[points.front().track][points.front().index];
    };
    const auto replace = [this, first](auto change) {
        Breakpoint point = first();
        change(point);
        m_document->replacePoint(m_document->selection().points.front(), point);
    };
    if (m_document->selection().points.size() == 1) {
        number(
            "time", tr("Time:"), QStringLiteral("s"), 0.0, Pattern::kLongest_s, 3,
            [first] { return first().time_s; },
            [replace](double value) { replace([value](Breakpoint& p) { p.time_s = value; }); });
        number(
            "intensity", tr("Intensity:"), QStringLiteral("%"), 0.0, kPercent, 1,
            [first] { return kPercent * first().intensity; },
            [replace](double value) { replace([value](Breakpoint& p) { p.intensity = value / kPercent; }); });
    } else {
        auto* scale = number(
            "scale", tr("Scale by:"), QStringLiteral("%"), 0.0, 1000.0, 0, [] { return kPercent; },
            [this](double value) { m_document->scaleIntensity(value / kPercent); });
        scale->setSingleStep(10.0);
        auto* stretch = number(
            "stretch", tr("Stretch to:"), QStringLiteral("%"), 1.0, 1000.0, 0, [] { return kPercent; },
            [this](double value) { m_document->stretch(value / kPercent); });
        stretch->setSingleStep(10.0);
    }
    auto* easing = new QComboBox(m_rows);
    easing->setObjectName(QStringLiteral("easing"));
    for (const Easing each : kEasings)
        easing->addItem(easingName(each));
    m_form->addRow(tr("Curve:"), easing);
    connect(easing, &QComboBox::activated, this,
            [this](int index) { m_document->setEasing(kEasings[static_cast<std::size_t>(index)]); });
    m_refresh.push_back([easing, first] {
        const auto at = std::find(kEasings.begin(), kEasings.end(), first().easing);
        easing->setCurrentIndex(static_cast<int>(at - kEasings.begin()));
    });
}

template <typename Form>
void PatternInspector::field(const char* name, const QString& label, const QString& unit, double low,
                             double high, int decimals, std::function<double(const Form&)> get,
                             std::function<void(Form&, double)> set) {
    const auto current = [this]() -> const Form* {
        const auto& object = m_document->selection().object;
        return object ? std::get_if<Form>(&m_document->pattern().objects[*object].form) : nullptr;
    };
    number(
        name, label, unit, low, high, decimals,
        [current, get = std::move(get)] { return current() ? get(*current()) : 0.0; },
        [this, current, set = std::move(set), key = QString::fromLatin1(name)](double value) {
            if (!current())
                return;
            const std::size_t index = *m_document->selection().object;
            PatternObject object = m_document->pattern().objects[index];
            set(std::get<Form>(object.form), value);
            m_document->replaceObject(index, object, key);
        });
}

template <typename Form>
void PatternInspector::tactors() {
    auto* box = new QLineEdit(m_rows);
    box->setObjectName(QStringLiteral("tactors"));
    box->setToolTip(tr("Numbers from 1 to 6, separated by spaces"));
    m_form->addRow(tr("Motors:"), box);
    m_refresh.push_back([this, box] {
        const auto& object = m_document->selection().object;
        const Form* form = object ? std::get_if<Form>(&m_document->pattern().objects[*object].form) : nullptr;
        QStringList numbers;
        if (form)
            for (const int tactor : form->tactors)
                numbers << QString::number(tactor + 1);
        box->setText(numbers.join(QLatin1Char(' ')));
    });
    connect(box, &QLineEdit::editingFinished, this, [this, box] {
        const auto index = m_document->selection().object;
        if (!index || !std::holds_alternative<Form>(m_document->pattern().objects[*index].form))
            return;
        PatternObject object = m_document->pattern().objects[*index];
        std::vector<int> numbers;
        for (const QString& part : box->text().split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
            const int tactor = part.toInt();
            if (tactor >= 1 && tactor <= static_cast<int>(core::kTactors))
                numbers.push_back(tactor - 1);
        }
        if (!numbers.empty()) {
            std::get<Form>(object.form).tactors = numbers;
            m_document->replaceObject(*index, object);
        }
        showSelection();
    });
}

void PatternInspector::buildObject() {
    const QString s = QStringLiteral("s");
    const QString percent = QStringLiteral("%");
    const double day_s = Pattern::kLongest_s;
    const auto start = [&]<typename Form>(Form*) {
        field<Form>(
            "start", tr("Start:"), s, 0.0, day_s, 3, [](const Form& f) { return f.start_s; },
            [](Form& f, double v) { f.start_s = v; });
    };
    const auto length = [&]<typename Form>(Form*) {
        field<Form>(
            "length", tr("Length:"), s, 0.01, day_s, 3, [](const Form& f) { return f.duration_s; },
            [](Form& f, double v) { f.duration_s = v; });
    };
    const auto strength = [&]<typename Form>(Form*) {
        field<Form>(
            "intensity", tr("Intensity:"), percent, 0.0, kPercent, 1,
            [](const Form& f) { return kPercent * f.intensity; },
            [](Form& f, double v) { f.intensity = v / kPercent; });
    };
    const ObjectForm& form = m_document->pattern().objects[*m_document->selection().object].form;
    std::visit([&]<typename Form>(const Form&) { start(static_cast<Form*>(nullptr)); }, form);
    if (std::holds_alternative<Sweep>(form)) {
        field<Sweep>(
            "burst", tr("Burst:"), s, 0.001, day_s, 3, [](const Sweep& f) { return f.burst_s; },
            [](Sweep& f, double v) { f.burst_s = v; });
        field<Sweep>(
            "onset", tr("Onset to onset:"), s, 0.001, day_s, 4, [](const Sweep& f) { return onsetOf_s(f); },
            [](Sweep& f, double v) { f.onset_s = v; });
        tactors<Sweep>();
        strength(static_cast<Sweep*>(nullptr));
    } else if (std::holds_alternative<Ring>(form)) {
        length(static_cast<Ring*>(nullptr));
        field<Ring>(
            "turns", tr("Turns:"), QString(), 1.0, 100.0, 0,
            [](const Ring& f) { return static_cast<double>(f.turns); },
            [](Ring& f, double v) { f.turns = static_cast<int>(v); });
        field<Ring>(
            "first", tr("First motor:"), QString(), 1.0, static_cast<double>(core::kTactors), 0,
            [](const Ring& f) { return f.firstTactor + 1.0; },
            [](Ring& f, double v) { f.firstTactor = static_cast<int>(v) - 1; });
        strength(static_cast<Ring*>(nullptr));
    } else if (std::holds_alternative<Phantom>(form)) {
        length(static_cast<Phantom*>(nullptr));
        field<Phantom>(
            "from", tr("From:"), percent, 0.0, kPercent, 0,
            [](const Phantom& f) { return kPercent * f.balanceFrom; },
            [](Phantom& f, double v) { f.balanceFrom = v / kPercent; });
        field<Phantom>(
            "to", tr("To:"), percent, 0.0, kPercent, 0,
            [](const Phantom& f) { return kPercent * f.balanceTo; },
            [](Phantom& f, double v) { f.balanceTo = v / kPercent; });
        strength(static_cast<Phantom*>(nullptr));
    } else if (std::holds_alternative<Ramp>(form)) {
        length(static_cast<Ramp*>(nullptr));
        field<Ramp>(
            "from", tr("From:"), percent, 0.0, kPercent, 1, [](const Ramp& f) { return kPercent * f.from; },
            [](Ramp& f, double v) { f.from = v / kPercent; });
        field<Ramp>(
            "to", tr("To:"), percent, 0.0, kPercent, 1, [](const Ramp& f) { return kPercent * f.to; },
            [](Ramp& f, double v) { f.to = v / kPercent; });
        tactors<Ramp>();
    } else if (std::holds_alternative<PulseTrain>(form)) {
        length(static_cast<PulseTrain*>(nullptr));
        field<PulseTrain>(
            "period", tr("Period:"), s, 0.001, day_s, 3, [](const PulseTrain& f) { return f.period_s; },
            [](PulseTrain& f, double v) { f.period_s = v; });
        field<PulseTrain>(
            "width", tr("Width:"), s, 0.001, day_s, 3, [](const PulseTrain& f) { return f.width_s; },
            [](PulseTrain& f, double v) { f.width_s = v; });
        tactors<PulseTrain>();
        strength(static_cast<PulseTrain*>(nullptr));
    } else {
        strength(static_cast<Stroke*>(nullptr));
    }
    auto* bake = new QPushButton(tr("Bake into breakpoints"), m_rows);
    bake->setObjectName(QStringLiteral("bake"));
    bake->setAutoDefault(false);
    m_form->addRow(bake);
    connect(bake, &QPushButton::clicked, this, [this] {
        if (m_document->selection().object)
            m_document->bakeObject(*m_document->selection().object);
    });
}

void PatternInspector::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        showPattern();
        rebuild();
        showSelection();
    }
}

} // namespace teleta::editor
