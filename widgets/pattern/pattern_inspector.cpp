// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/pattern/pattern_inspector.h"

#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/pattern/timeline/timeline_menu.h"
#include "widgets/pattern/timeline/timeline_painter.h"

#include <QHBoxLayout>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

namespace teleta::pattern {

namespace {
constexpr double kLeastField_em = 5.0;  ///< a time with its unit
constexpr double kLeastChoice_em = 5.8; ///< a short one, or the begin of another

/// Scrolls up and down only: never narrower than its fields.
class FieldScroll : public QScrollArea {
public:
    using QScrollArea::QScrollArea;
    [[nodiscard]] QSize minimumSizeHint() const override {
        return {widget()->minimumSizeHint().width() + verticalScrollBar()->sizeHint().width(),
                QScrollArea::minimumSizeHint().height()};
    }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (watched == widget() && event->type() == QEvent::LayoutRequest)
            updateGeometry();
        return QScrollArea::eventFilter(watched, event);
    }
};

/// Nobody types into the widest value that there could be.
void letShrink(QWidget* field, double least_em) {
    field->setMinimumWidth(base::em(field, least_em));
}

} // namespace

PatternInspector::PatternInspector(PatternDocument* document, QWidget* parent)
    : QWidget(parent)
    , m_document(document) {
    m_duration->setRange(0.01, Pattern::kLongest_s);
    for (QDoubleSpinBox* box : {m_duration, m_loopBegin, m_loopEnd}) {
        box->setDecimals(3);
        box->setSingleStep(0.1);
        box->setKeyboardTracking(false);
        box->setSuffix(QStringLiteral(" s"));
    }
    m_notes->setTabChangesFocus(true);
    m_notes->setFixedHeight(base::em(this, 3.4));
    m_title->setFont(base::bold(base::sized(font(), base::kTitleText)));
    const auto inARow = [this](QWidget* first, QWidget* second) {
        auto* row = new QWidget(this);
        auto* both = new QHBoxLayout(row);
        both->setContentsMargins(0, 0, 0, 0);
        both->addWidget(first, 1);
        both->addWidget(second, 1);
        return row;
    };
    for (QDoubleSpinBox* box : {m_loopBegin, m_loopEnd}) {
        box->setRange(0.0, Pattern::kLongest_s);
        connect(box, &QDoubleSpinBox::valueChanged, this, [this] {
            if (!m_showing)
                emit loopEdited(m_loopBegin->value(), m_loopEnd->value());
        });
    }
    QWidget* loop = inARow(m_loopBegin, m_loopEnd);
    for (QComboBox* box : {m_task, m_condition})
        for (int k = 0; k < 3; ++k)
            box->addItem(QString());
    QWidget* kinds = inARow(m_task, m_condition);
    connect(m_task, &QComboBox::activated, this,
            [this](int index) { m_document->setTask(static_cast<Task>(index)); });
    connect(m_condition, &QComboBox::activated, this,
            [this](int index) { m_document->setCondition(static_cast<Condition>(index)); });
    for (QWidget* row : std::initializer_list<QWidget*>{m_name, m_duration, loop, kinds, m_tags, m_notes})
        m_top->addRow(new QLabel(this), row);
    auto* inside = new QWidget;
    auto* layout = new QVBoxLayout(inside);
    layout->addLayout(m_top);
    layout->addWidget(m_title);
    m_rows = new QWidget(inside);
    layout->addWidget(m_rows);
    layout->addStretch(1);
    for (QWidget* field : std::initializer_list<QWidget*>{m_duration, m_loopBegin, m_loopEnd})
        letShrink(field, kLeastField_em);
    for (QWidget* choice : {m_task, m_condition})
        letShrink(choice, kLeastChoice_em);
    auto* scroll = new FieldScroll(this);
    scroll->setWidgetResizable(true);
    scroll->setFocusPolicy(Qt::NoFocus); // Tab goes to its fields instead
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
    base::onChange(this,
                   [this] {
                       showPattern();
                       rebuild();
                       showSelection();
                   },
                   {QEvent::LanguageChange});
    showPattern();
    rebuild();
}

void PatternInspector::showPattern() {
    m_showing = true;
    const auto describe = [this](QWidget* row, QWidget* box, const QString& text) {
        auto* label = qobject_cast<QLabel*>(m_top->labelForField(row));
        label->setText(text);
        label->setBuddy(box);
    };
    describe(m_name, m_name, tr("&Name:"));
    describe(m_duration, m_duration, tr("Le&ngth:"));
    describe(m_loopBegin->parentWidget(), m_loopBegin, tr("&Loop:"));
    m_loopBegin->setAccessibleName(tr("Begin of the loop"));
    m_loopEnd->setAccessibleName(tr("End of the loop"));
    for (QDoubleSpinBox* box : {m_loopBegin, m_loopEnd})
        box->setToolTip(tr("The range that is repeated; the whole pattern when both times are equal"));
    describe(m_task->parentWidget(), m_task, tr("T&ells:"));
    m_condition->setAccessibleName(tr("Condition"));
    const QStringList tasks{tr("a shape"), tr("a stiffness"), tr("something else")};
    const QStringList conditions{tr("no condition"), tr("static"), tr("dynamic")};
    for (int k = 0; k < 3; ++k) {
        m_task->setItemText(k, tasks[k]);
        m_condition->setItemText(k, conditions[k]);
    }
    describe(m_tags, m_tags, tr("&Tags:"));
    describe(m_notes, m_notes, tr("N&otes:"));
    const Pattern& pattern = m_document->pattern();
    const auto show = [](auto* box, const QString& now, const QString& wanted, auto set) {
        if (now != wanted) // keeps the cursor in place
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
    m_task->setCurrentIndex(static_cast<int>(pattern.task));
    m_condition->setCurrentIndex(static_cast<int>(pattern.condition));
    m_showing = false;
}

void PatternInspector::setLoop(const std::optional<Span>& loop) {
    m_showing = true;
    m_loopBegin->setValue(loop ? loop->begin_s : 0.0);
    m_loopEnd->setValue(loop ? loop->end_s : 0.0);
    m_showing = false;
}

void PatternInspector::showSelection() {
    const Selection& selection = m_document->selection();
    if (kindOfSelection() != m_kind)
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

QString PatternInspector::kindOfSelection() const {
    const Selection& selection = m_document->selection();
    if (selection.object)
        return QStringLiteral("object %1").arg(m_document->pattern().objects[*selection.object].form.index());
    if (selection.points.empty())
        return {};
    return selection.points.size() == 1 ? QStringLiteral("point") : QStringLiteral("points");
}

void PatternInspector::rebuild() {
    const Selection& selection = m_document->selection();
    m_kind = kindOfSelection();
    m_refresh.clear();
    auto* rows = new QWidget(m_rows->parentWidget());
    m_form = new QFormLayout(rows);
    m_form->setContentsMargins(0, 0, 0, 0);
    m_rows->parentWidget()->layout()->replaceWidget(m_rows, rows);
    m_rows->hide();
    m_rows->deleteLater(); // the caller may be one of its boxes
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
    letShrink(box, kLeastField_em);
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
    auto* easing = easingBox("easing");
    connect(easing, &QComboBox::activated, this, [this, easing](int index) {
        m_document->setEasing(static_cast<Easing>(easing->itemData(index).toInt()));
    });
    m_refresh.push_back(
        [easing, first] { easing->setCurrentIndex(easing->findData(static_cast<int>(first().easing))); });
}

QComboBox* PatternInspector::easingBox(const char* name) {
    auto* box = new QComboBox(m_rows);
    box->setObjectName(QLatin1String(name));
    for (const Easing easing : kEasings)
        box->addItem(easingName(easing), static_cast<int>(easing));
    letShrink(box, kLeastField_em);
    m_form->addRow(tr("Curve:"), box);
    return box;
}

} // namespace teleta::pattern
