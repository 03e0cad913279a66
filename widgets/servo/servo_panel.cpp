// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/servo/servo_panel.h"

#include "widgets/base/controls/provenance_stripe.h"
#include "widgets/base/icons.h"
#include "widgets/base/numbers/number_format.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/servo/force_strip.h"
#include "widgets/servo/servo_picture.h"
#include "widgets/servo/servo_texts.h"

#include <QAbstractItemView>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStringList>
#include <QToolButton>
#include <QVBoxLayout>

#include <cmath>
#include <utility>

namespace teleta::servo {

namespace {

QDoubleSpinBox* spinBox(QWidget* parent, double lowest, double highest, double step, int decimals) {
    auto* box = new QDoubleSpinBox(parent);
    box->setRange(lowest, highest);
    box->setSingleStep(step);
    box->setDecimals(decimals);
    // A number that is still being typed is not emitted.
    box->setKeyboardTracking(false);
    return box;
}

bool same(const ServoTuning& a, const ServoTuning& b) {
    return std::abs(a.force_N - b.force_N) < 1e-6 && std::abs(a.slide_mPerS - b.slide_mPerS) < 1e-9 &&
           std::abs(a.gain - b.gain) < 1e-6 && a.moment == b.moment;
}

} // namespace

ServoPanel::ServoPanel(QWidget* parent)
    : QWidget(parent)
    , m_run(new QPushButton(base::themeIcon(base::Icon::play), {}, this))
    , m_hold(new QPushButton(base::themeIcon(base::Icon::pause), {}, this))
    , m_restart(new QPushButton(base::themeIcon(base::Icon::toStart), {}, this))
    , m_state(new QLabel(this))
    , m_limits(new QLabel(this))
    , m_verdict(new QLabel(this))
    , m_picture(new ServoPicture(this))
    , m_force20s(new ForceStrip(this))
    , m_cost(new QLabel(this))
    , m_form(new QFormLayout)
    , m_tasksName(new QLabel(this))
    , m_tasks(new QComboBox(this))
    , m_force(spinBox(this, ServoTuning::kLeastForce_N, ServoTuning::kHighestForce_N, 0.5, 1))
    , m_slide(spinBox(this, 0.0, 1e3 * ServoTuning::kHighestSlide_mPerS, 0.5, 1))
    , m_gain(spinBox(this, 100.0 * ServoTuning::kLeastGain, 100.0 * ServoTuning::kHighestGain, 10.0, 0))
    , m_moment(new QCheckBox(this))
    , m_changes(new QLabel(this))
    , m_planned(new QPushButton(this)) {
    m_state->setFont(base::bold(base::sized(font(), base::kLargeText)));
    m_state->setWordWrap(true);
    m_limits->setWordWrap(true);
    m_verdict->setWordWrap(true);
    m_cost->setWordWrap(true);
    m_cost->setFont(base::sized(font(), base::kSmallText));
    m_state->setObjectName(QStringLiteral("servoState"));
    m_limits->setObjectName(QStringLiteral("servoLimits"));
    m_verdict->setObjectName(QStringLiteral("servoVerdict"));
    m_cost->setObjectName(QStringLiteral("servoCost"));
    m_force->setObjectName(QStringLiteral("servoForce"));
    m_slide->setObjectName(QStringLiteral("servoSlide"));
    m_gain->setObjectName(QStringLiteral("servoGain"));
    m_moment->setObjectName(QStringLiteral("servoMoment"));
    m_changes->setObjectName(QStringLiteral("servoChanges"));
    m_changes->setWordWrap(true);
    m_planned->setObjectName(QStringLiteral("servoPlanned"));
    m_planned->setAutoDefault(false);
    m_matrices->setObjectName(QStringLiteral("servoMatrices"));
    m_matrices->setCheckable(true);
    m_matrices->setArrowType(Qt::RightArrow);
    m_matrices->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_tasks->setObjectName(QStringLiteral("servoTask"));
    m_force->setSuffix(QStringLiteral(" N"));
    m_slide->setSuffix(QStringLiteral(" mm/s"));
    m_gain->setSuffix(QStringLiteral(" %"));

    auto* layout = new QVBoxLayout(this);
    const int margin = base::grid(this);
    layout->setContentsMargins(margin, margin, margin, margin);
    layout->setSpacing(margin / 2);
    m_run->setObjectName(QStringLiteral("servoRun"));
    m_hold->setObjectName(QStringLiteral("servoHold"));
    m_restart->setObjectName(QStringLiteral("servoRestart"));
    auto* program = new QHBoxLayout;
    for (QPushButton* button : {m_run, m_hold, m_restart}) {
        button->setAutoDefault(false);
        program->addWidget(button, 1);
    }
    layout->addLayout(program);
    m_tasksName->setBuddy(m_tasks);
    m_form->addRow(m_tasksName, m_tasks);
    for (QWidget* field : {m_force, m_slide, m_gain}) {
        auto* name = new QLabel(this);
        name->setBuddy(field);
        m_form->addRow(name, field);
    }
    m_form->addRow(m_moment);
    layout->addLayout(m_form);
    layout->addWidget(m_changes);
    layout->addWidget(m_planned, 0, Qt::AlignLeft);
    layout->addWidget(m_state);
    layout->addWidget(m_limits);
    layout->addWidget(m_verdict);
    layout->addWidget(m_force20s);
    layout->addWidget(m_picture);
    layout->addWidget(m_matrices, 0, Qt::AlignLeft);
    layout->addWidget(m_cost);
    layout->addStretch(1);

    // Changes only the edited value, because the fields show the others rounded.
    const auto wishes = [this](auto signalOf, auto* field, auto change) {
        connect(field, signalOf, this, [this, change](auto value) {
            if (!m_report)
                return;
            ServoTuning changed = m_wish.value_or(m_report->tuning);
            change(changed, value);
            wish(changed);
        });
    };
    connect(m_run, &QPushButton::clicked, this, [this] { emit runRequested(true); });
    connect(m_hold, &QPushButton::clicked, this, [this] { emit runRequested(false); });
    connect(m_restart, &QPushButton::clicked, this, &ServoPanel::restartRequested);
    connect(m_matrices, &QToolButton::toggled, this, [this](bool shown) {
        m_matrices->setArrowType(shown ? Qt::DownArrow : Qt::RightArrow);
        m_picture->showMatrices(shown);
    });
    connect(m_planned, &QPushButton::clicked, this, [this] {
        if (!m_report)
            return;
        wish(m_report->planned);
        showTuning(m_report->planned, m_report->bounds);
    });
    wishes(&QDoubleSpinBox::valueChanged, m_force,
           [](ServoTuning& wish, double value) { wish.force_N = value; });
    wishes(&QDoubleSpinBox::valueChanged, m_slide,
           [](ServoTuning& wish, double value) { wish.slide_mPerS = 1e-3 * value; });
    wishes(&QDoubleSpinBox::valueChanged, m_gain,
           [](ServoTuning& wish, double value) { wish.gain = 0.01 * value; });
    wishes(&QCheckBox::toggled, m_moment, [](ServoTuning& wish, bool value) { wish.moment = value; });
    connect(m_tasks, &QComboBox::activated, this,
            [this](int index) { emit taskRequested(static_cast<std::size_t>(index)); });
    base::keepTranslated(this, &ServoPanel::retranslate);
    base::onChange(this, &ServoPanel::showTexts, {QEvent::PaletteChange});
    setReport(std::nullopt);
}

void ServoPanel::setProvenance(base::Provenance provenance) {
    m_shownProvenance = provenance;
    showTexts();
}

void ServoPanel::setReport(const std::optional<ServoReport>& report) {
    if (!report || !m_report)
        m_lastVerdict.reset();
    else if (report->restarts != m_report->restarts)
        m_lastVerdict = m_report->verdict;
    m_report = report;
    m_picture->setReport(report);
    m_force20s->setReport(report);
    setEnabled(report.has_value());
    if (!report)
        m_wish.reset();
    showTexts();
    showTasks();
    if (!report)
        return;
    if (m_wish && same(*m_wish, report->tuning))
        m_wish.reset();
    if (!m_wish)
        showTuning(report->tuning, report->bounds);
    showChanges();
}

void ServoPanel::wish(const ServoTuning& tuning) {
    m_wish = tuning;
    showChanges();
    emit tuningChanged(tuning);
}

void ServoPanel::showChanges() {
    QStringList changes;
    if (m_report) {
        const ServoTuning& planned = m_report->planned;
        const ServoTuning used = m_wish.value_or(m_report->tuning);
        const QLocale locale;
        const auto isOther = [](double a, double b) { return std::abs(a - b) > 1e-9; };
        if (isOther(used.force_N, planned.force_N))
            changes << tr("force %1", "as planned")
                           .arg(base::withUnit(locale.toString(planned.force_N), QStringLiteral("N")));
        if (isOther(used.slide_mPerS, planned.slide_mPerS))
            changes << tr("sliding speed %1", "as planned")
                           .arg(base::withUnit(locale.toString(1e3 * planned.slide_mPerS),
                                               QStringLiteral("mm/s")));
        if (isOther(used.gain, planned.gain))
            changes << tr("gains %1", "as planned")
                           .arg(base::withUnit(locale.toString(100.0 * planned.gain), QStringLiteral("%")));
        if (used.moment != planned.moment)
            changes << (planned.moment ? tr("moment balanced") : tr("moment not balanced"));
    }
    m_changes->setVisible(!changes.isEmpty());
    m_planned->setVisible(!changes.isEmpty());
    if (!changes.isEmpty())
        m_changes->setText(tr("Changed from the scene, and kept after a restart. The scene has: %1.")
                               .arg(changes.join(QStringLiteral(", "))));
}

void ServoPanel::setStopEngaged(bool engaged) {
    if (std::exchange(m_stopEngaged, engaged) != engaged)
        showTexts();
}

void ServoPanel::showTexts() {
    showVerdict();
    const base::StatusColours& colours = base::statusColours(palette());
    base::showProvenance(this, m_report ? m_shownProvenance : base::Provenance::live);
    if (!m_report) {
        m_state->setText(tr("No servo"));
        base::setTextColour(m_state, palette().color(QPalette::WindowText));
        m_limits->clear();
        m_cost->clear();
        return;
    }
    m_cost->setText(ServoTexts::cost(m_report->times, m_report->rate_Hz));
    const ServoOutput& output = m_report->output;
    const bool isHeld = m_report->stopped && !m_stopEngaged;
    // During STOP nothing goes on; what is held stays held after it.
    m_run->setEnabled(!m_stopEngaged);
    m_restart->setEnabled(!m_stopEngaged);
    m_state->setText(isHeld              ? tr("The scene is held")
                     : m_report->stopped ? tr("STOP: the arm is held")
                                         : ServoTexts::contact(output.contact));
    m_state->setToolTip(m_report->stopped
                            ? tr("The arm keeps the pose that it had. It no longer presses beyond it: the "
                                 "force falls to what pushes against the arm.")
                            : QString());
    const bool isStopped = m_report->stopped && !isHeld;
    const bool gone = !m_report->stopped && output.contact == ContactState::lost;
    const bool searches = !m_report->stopped && output.contact == ContactState::searching;
    base::setTextColour(m_state, isStopped || gone ? colours.lost
                                 : searches        ? colours.stale
                                                   : palette().color(QPalette::WindowText));
    const QString limits = ServoTexts::limits(m_report->recentLimits);
    m_limits->setText(limits.isEmpty() ? tr("No limit acts.") : tr("Limits that act: %1").arg(limits));
    base::setTextColour(m_limits, limits.isEmpty() ? colours.neutral : colours.stale);
}

void ServoPanel::showVerdict() {
    QStringList lines;
    if (m_report && m_report->verdict)
        lines << tr("So far: %1")
                     .arg(m_report->verdict->completed ? tr("as planned")
                                                       : ServoTexts::verdict(*m_report->verdict));
    if (m_lastVerdict)
        lines << tr("Last run: %1").arg(ServoTexts::verdict(*m_lastVerdict));
    m_verdict->setText(lines.join(QLatin1Char('\n')));
    m_verdict->setVisible(!lines.isEmpty());
}

void ServoPanel::showTasks() {
    const QSignalBlocker blocker(m_tasks);
    const int count = m_report ? static_cast<int>(m_report->tasks) : 0;
    QStringList names;
    for (int i = 0; i < count; ++i)
        names << tr("%1. %2", "number and name of a task")
                     .arg(i + 1)
                     .arg(ServoTexts::task(m_report->plan[static_cast<std::size_t>(i)]));
    QStringList present;
    for (int i = 0; i < m_tasks->count(); ++i)
        present << m_tasks->itemText(i);
    if (names != present) {
        m_tasks->clear();
        m_tasks->addItems(names);
    }
    if (m_report && !m_tasks->view()->isVisible())
        m_tasks->setCurrentIndex(static_cast<int>(m_report->output.phase));
}

void ServoPanel::showTuning(const ServoTuning& tuning, const TuningBounds& bounds) {
    const QSignalBlocker force(m_force);
    const QSignalBlocker slide(m_slide);
    const QSignalBlocker gain(m_gain);
    const QSignalBlocker moment(m_moment);
    m_force->setRange(bounds.leastForce_N, bounds.highestForce_N);
    m_slide->setRange(0.0, 1e3 * bounds.highestSlide_mPerS);
    // Setting a value would overwrite what is being typed.
    if (!m_force->hasFocus())
        m_force->setValue(tuning.force_N);
    if (!m_slide->hasFocus())
        m_slide->setValue(1e3 * tuning.slide_mPerS);
    if (!m_gain->hasFocus())
        m_gain->setValue(100.0 * tuning.gain);
    m_moment->setChecked(tuning.moment);
}

void ServoPanel::retranslate() {
    const auto label = [this](QWidget* field, const QString& text, const QString& toolTip) {
        if (auto* name = qobject_cast<QLabel*>(m_form->labelForField(field)))
            name->setText(text);
        field->setToolTip(toolTip);
        field->setAccessibleName(QString(text).remove(QLatin1Char('&')));
    };
    m_run->setText(tr("Run"));
    m_run->setToolTip(tr("Let the scene go on (F5)"));
    m_hold->setText(tr("Hold"));
    m_hold->setToolTip(tr("Hold the scene where it is (Shift+F5)"));
    m_restart->setText(tr("Restart"));
    m_restart->setToolTip(tr("Start the scene again (Ctrl+F5)"));
    const QString task = tr("&Task");
    m_tasksName->setText(task);
    m_tasks->setToolTip(tr("The running task; choose one to start it now"));
    m_tasks->setAccessibleName(QString(task).remove(QLatin1Char('&')));
    label(m_force, tr("F&orce"), tr("Force with which the array presses"));
    label(m_slide, tr("&Sliding speed"), tr("Along the edge, while it is explored"));
    label(m_gain, tr("&Gains"), tr("All controller gains, in percent of those in the scene"));
    m_moment->setText(tr("Balance the &moment (DZMP)"));
    m_moment->setToolTip(tr("Off: the controller without the distance to the zero-moment point"));
    m_matrices->setText(tr("Matrices"));
    m_planned->setText(tr("Reset to the scene"));
    m_planned->setToolTip(tr("Set force, speed, gains and moment back to the values of the scene"));
    showChanges();
    showTexts();
    showTasks();
}

} // namespace teleta::servo
