// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of the inspector for parametric objects.
#include "widgets/pattern/pattern_inspector.h"
#include "widgets/pattern/timeline/timeline_menu.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLineEdit>
#include <QPushButton>

#include <algorithm>
#include <numbers>

namespace teleta::pattern {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kMostAngle_deg = 3600.0;

double lengthOf_s(const Stroke& stroke) {
    return stroke.points.empty() ? 0.0 : stroke.points.back().time_s;
}

/// Rescales the times of a stroke to another length.
void setLength(Stroke& stroke, double length_s) {
    const double now_s = lengthOf_s(stroke);
    if (!(now_s > 0.0))
        return;
    for (StrokePoint& point : stroke.points)
        point.time_s *= length_s / now_s;
}

void turnTo(Stroke& stroke, double first_rad) {
    const double by_rad = first_rad - stroke.points.front().angle_rad;
    for (StrokePoint& point : stroke.points)
        point.angle_rad += by_rad;
}

} // namespace

template <typename Form>
const Form* PatternInspector::selectedForm() const {
    const auto& object = m_document->selection().object;
    return object ? std::get_if<Form>(&m_document->pattern().objects[*object].form) : nullptr;
}

template <typename Form, typename Change>
void PatternInspector::change(Change change, const QString& field) {
    if (!selectedForm<Form>())
        return;
    const std::size_t index = *m_document->selection().object;
    PatternObject object = m_document->pattern().objects[index];
    change(std::get<Form>(object.form));
    m_document->replaceObject(index, object, field);
}

template <typename Form>
void PatternInspector::field(const char* name, const QString& label, const QString& unit, double low,
                             double high, int decimals, std::function<double(const Form&)> get,
                             std::function<void(Form&, double)> set) {
    number(
        name, label, unit, low, high, decimals,
        [this, get = std::move(get)] { return selectedForm<Form>() ? get(*selectedForm<Form>()) : 0.0; },
        [this, set = std::move(set), key = QString::fromLatin1(name)](double value) {
            change<Form>([&](Form& form) { set(form, value); }, key);
        });
}

template <typename Form>
void PatternInspector::field(const char* name, const QString& label, const QString& unit, double low,
                             double high, int decimals, double Form::*value) {
    const double scale = unit == QLatin1String("%") ? kPercent : 1.0;
    field<Form>(
        name, label, unit, low, high, decimals, [value, scale](const Form& f) { return scale * (f.*value); },
        [value, scale](Form& f, double v) { f.*value = v / scale; });
}

template <typename Form>
void PatternInspector::motor(const char* name, const QString& label, int Form::*tactor) {
    field<Form>(
        name, label, QString(), 1.0, static_cast<double>(core::kTactors), 0,
        [tactor](const Form& f) { return f.*tactor + 1.0; },
        [tactor](Form& f, double v) { f.*tactor = static_cast<int>(v) - 1; });
}

template <typename Form>
void PatternInspector::tactors() {
    auto* box = new QLineEdit(m_rows);
    box->setObjectName(QStringLiteral("tactors"));
    box->setToolTip(tr("Numbers from 1 to 6, separated by spaces"));
    m_form->addRow(tr("Motors:"), box);
    m_refresh.push_back([this, box] {
        const Form* form = selectedForm<Form>();
        QStringList numbers;
        if (form)
            for (const int tactor : form->tactors)
                numbers << QString::number(tactor + 1);
        box->setText(numbers.join(QLatin1Char(' ')));
    });
    connect(box, &QLineEdit::editingFinished, this, [this, box] {
        std::vector<int> numbers;
        for (const QString& part : box->text().split(QLatin1Char(' '), Qt::SkipEmptyParts)) {
            const int tactor = part.toInt();
            if (tactor >= 1 && tactor <= static_cast<int>(core::kTactors))
                numbers.push_back(tactor - 1);
        }
        if (!numbers.empty())
            change<Form>([&](Form& form) { form.tactors = numbers; });
        showSelection();
    });
}

template <typename Form>
void PatternInspector::check(const char* name, const QString& label, std::function<bool(const Form&)> get,
                             std::function<void(Form&, bool)> set) {
    auto* box = new QCheckBox(label, m_rows);
    box->setObjectName(QLatin1String(name));
    m_form->addRow(QString(), box);
    m_refresh.push_back([this, box, get = std::move(get)] {
        const Form* form = selectedForm<Form>();
        box->setChecked(form && get(*form));
    });
    connect(box, &QCheckBox::toggled, this, [this, set = std::move(set)](bool on) {
        if (!m_showing)
            change<Form>([&](Form& form) { set(form, on); });
    });
}

void PatternInspector::buildForm(const Sweep& /*form*/) {
    const auto byLaw = [](const Sweep& f) { return !f.onset_s; };
    field("burst", tr("Burst:"), QStringLiteral("s"), 0.001, Pattern::kLongest_s, 3, &Sweep::burst_s);
    field<Sweep>(
        "onset", tr("Onset to onset:"), QStringLiteral("s"), 0.001, Pattern::kLongest_s, 4,
        [](const Sweep& f) { return onsetOf_s(f); }, [](Sweep& f, double v) { f.onset_s = v; });
    check<Sweep>("onsetByLaw", tr("Onset by the law of apparent motion"), byLaw,
                 [](Sweep& f, bool on) { f.onset_s = on ? std::nullopt : std::optional(onsetOf_s(f)); });
    tactors<Sweep>();
}

void PatternInspector::buildForm(const Ring& /*form*/) {
    field<Ring>(
        "turns", tr("Turns:"), QString(), 1.0, 100.0, 0,
        [](const Ring& f) { return static_cast<double>(f.turns); },
        [](Ring& f, double v) { f.turns = static_cast<int>(v); });
    motor<Ring>("first", tr("First motor:"), &Ring::firstTactor);
    check<Ring>(
        "counterClockwise", tr("Counter-clockwise (rising numbers)"),
        [](const Ring& f) { return f.counterClockwise; }, [](Ring& f, bool on) { f.counterClockwise = on; });
    field<Ring>(
        "burst", tr("Burst:"), QStringLiteral("s"), 0.001, Pattern::kLongest_s, 4,
        [](const Ring& f) { return burstOf_s(f); }, [](Ring& f, double v) { f.burst_s = v; });
    check<Ring>(
        "burstByLaw", tr("Burst by the law of apparent motion"), [](const Ring& f) { return !f.burst_s; },
        [](Ring& f, bool on) { f.burst_s = on ? std::nullopt : std::optional(burstOf_s(f)); });
}

void PatternInspector::buildForm(const Phantom& /*form*/) {
    const QString percent = QStringLiteral("%");
    motor<Phantom>("first", tr("First motor:"), &Phantom::first);
    motor<Phantom>("second", tr("Second motor:"), &Phantom::second);
    field("from", tr("From:"), percent, 0.0, kPercent, 0, &Phantom::balanceFrom);
    field("to", tr("To:"), percent, 0.0, kPercent, 0, &Phantom::balanceTo);
}

void PatternInspector::buildForm(const Ramp& /*form*/) {
    const QString percent = QStringLiteral("%");
    field("from", tr("From:"), percent, 0.0, kPercent, 1, &Ramp::from);
    field("to", tr("To:"), percent, 0.0, kPercent, 1, &Ramp::to);
    auto* easing = easingBox("easing");
    m_refresh.push_back([this, easing] {
        if (const Ramp* ramp = selectedForm<Ramp>())
            easing->setCurrentIndex(easing->findData(static_cast<int>(ramp->easing)));
    });
    connect(easing, &QComboBox::activated, this, [this, easing](int index) {
        change<Ramp>([&](Ramp& f) { f.easing = static_cast<Easing>(easing->itemData(index).toInt()); });
    });
    tactors<Ramp>();
}

void PatternInspector::buildForm(const PulseTrain& /*form*/) {
    const QString s = QStringLiteral("s");
    field("period", tr("Period:"), s, 0.001, Pattern::kLongest_s, 3, &PulseTrain::period_s);
    field("width", tr("Width:"), s, 0.001, Pattern::kLongest_s, 3, &PulseTrain::width_s);
    tactors<PulseTrain>();
}

void PatternInspector::buildForm(const Stroke& stroke) {
    const QString degrees = QStringLiteral("\u00b0");
    field<Stroke>("length", tr("Length:"), QStringLiteral("s"), 0.01, Pattern::kLongest_s, 3, lengthOf_s,
                  setLength);
    field<Stroke>(
        "turned", tr("Begins at:"), degrees, -kMostAngle_deg, kMostAngle_deg, 1,
        [](const Stroke& f) { return f.points.empty() ? 0.0 : kDegrees * f.points.front().angle_rad; },
        [](Stroke& f, double v) {
            if (!f.points.empty())
                turnTo(f, v / kDegrees);
        });
    // Its points are shown one at a time.
    const auto at = [this](const Stroke& f) {
        return std::min(m_strokePoint, f.points.empty() ? 0 : f.points.size() - 1);
    };
    auto* which = number(
        "point", tr("Point:"), QString(), 1.0,
        static_cast<double>(std::max<std::size_t>(1, stroke.points.size())), 0,
        [this, at] {
            const Stroke* f = selectedForm<Stroke>();
            return f ? static_cast<double>(at(*f) + 1) : 1.0;
        },
        [this](double value) {
            m_strokePoint = static_cast<std::size_t>(value) - 1;
            showSelection();
        });
    m_refresh.push_back([this, which] {
        if (const Stroke* f = selectedForm<Stroke>())
            which->setMaximum(static_cast<double>(std::max<std::size_t>(1, f->points.size())));
    });
    const auto pointField = [&](const char* name, const QString& label, const QString& unit, double low,
                                double high, int decimals, double scale, double StrokePoint::*value) {
        field<Stroke>(
            name, label, unit, low, high, decimals,
            [at, scale, value](const Stroke& f) {
                return f.points.empty() ? 0.0 : scale * (f.points[at(f)].*value);
            },
            [at, scale, value](Stroke& f, double v) {
                if (f.points.empty())
                    return;
                const std::size_t k = at(f);
                f.points[k].*value = v / scale;
                // Times of a stroke never decrease.
                const double earliest_s = k > 0 ? f.points[k - 1].time_s : 0.0;
                const double latest_s =
                    k + 1 < f.points.size() ? f.points[k + 1].time_s : Pattern::kLongest_s;
                f.points[k].time_s = std::clamp(f.points[k].time_s, earliest_s, latest_s);
            });
    };
    pointField("pointTime", tr("its time:"), QStringLiteral("s"), 0.0, Pattern::kLongest_s, 3, 1.0,
               &StrokePoint::time_s);
    pointField("pointAngle", tr("its angle:"), degrees, -kMostAngle_deg, kMostAngle_deg, 1, kDegrees,
               &StrokePoint::angle_rad);
    pointField("pointAlong", tr("along the arm:"), QStringLiteral("%"), 0.0, kPercent, 1, kPercent,
               &StrokePoint::along);
}

void PatternInspector::buildObject() {
    auto* name = new QLineEdit(m_rows);
    name->setObjectName(QStringLiteral("objectName"));
    m_form->addRow(tr("Called:"), name);
    m_refresh.push_back([this, name] {
        const auto& index = m_document->selection().object;
        const QString now =
            index ? QString::fromStdString(m_document->pattern().objects[*index].name) : QString();
        if (name->text() != now)
            name->setText(now);
    });
    connect(name, &QLineEdit::textEdited, this, [this](const QString& text) {
        const auto index = m_document->selection().object;
        if (!index)
            return;
        PatternObject object = m_document->pattern().objects[*index];
        object.name = text.toStdString();
        m_document->replaceObject(*index, object, QStringLiteral("objectName"));
    });
    std::visit(
        [this]<typename Form>(const Form& form) {
            const QString s = QStringLiteral("s");
            field("start", tr("Start:"), s, 0.0, Pattern::kLongest_s, 3, &Form::start_s);
            if constexpr (requires { form.duration_s; })
                field("length", tr("Length:"), s, 0.01, Pattern::kLongest_s, 3, &Form::duration_s);
            buildForm(form);
            if constexpr (requires { form.intensity; })
                field("intensity", tr("Intensity:"), QStringLiteral("%"), 0.0, kPercent, 1, &Form::intensity);
        },
        m_document->pattern().objects[*m_document->selection().object].form);
    auto* bake = new QPushButton(tr("Bake into breakpoints"), m_rows);
    bake->setObjectName(QStringLiteral("bake"));
    bake->setAutoDefault(false);
    m_form->addRow(bake);
    connect(bake, &QPushButton::clicked, this, [this] {
        if (m_document->selection().object)
            m_document->bakeObject(*m_document->selection().object);
    });
}

} // namespace teleta::pattern
