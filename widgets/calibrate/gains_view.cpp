// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/calibrate/gains_view.h"

#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QStringList>
#include <QUndoStack>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace teleta::calibrate {

namespace {

using equilibration::TaxelGain;
using equilibration::TaxelGains;
using equilibration::TaxelState;

constexpr int kProgressSteps = 1000;
/// Of the room of two pictures: its width over its height.
constexpr double kWide = 1.6;
constexpr double kLeastPicture_em = 10.0;

/// Has as much of the height as the other picture, not as much as it would like.
void share(QWidget* picture) {
    picture->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);
    picture->setMinimumHeight(base::em(picture, kLeastPicture_em));
}

QString percent(double share, int decimals) {
    return base::fixedDigits(100.0 * share, decimals);
}

int countOf(const TaxelGains& gains, TaxelState state) {
    return static_cast<int>(std::ranges::count(gains.taxels, state, &TaxelGain::state));
}

} // namespace

GainsView::GainsView(QWidget* parent)
    : CalibrationView({"undo", "redo", "load", "reset", "save"}, parent) {
    m_progress->setRange(0, kProgressSteps);
    m_progress->setTextVisible(false);
    m_uneven->setFont(base::bold(font()));
    m_uneven->setWordWrap(true);
    m_uneven->setObjectName(QStringLiteral("unevenness"));
    // Keeps its height without text, so that the map does not move under the mouse.
    m_readout->setFixedHeight(base::em(this, 1.4));
    auto* gains = new QVBoxLayout;
    share(m_map);
    gains->addWidget(m_map, 1);
    gains->addWidget(m_readout);
    m_pictures->setSpacing(base::grid(this));
    m_pictures->addLayout(gains, 1);
    auto* body = new QHBoxLayout;
    body->setSpacing(base::grid(this, 2.0));
    body->addWidget(makeSteps(), 2);
    body->addLayout(m_pictures, 3);
    page().addLayout(body, 1);

    connect(m_map, &GainMap::readoutChanged, m_readout, &QLabel::setText);
    connect(m_map, &GainMap::exportFailed, this, &GainsView::exportFailed);
    const auto act = [this](const char* name, auto slot) {
        connect(button(name), &QPushButton::clicked, this, slot);
    };
    act("reset", [this] { take({}); });
    act("tare", &GainsView::tareRequested);
    act("collect", &GainsView::collectRequested);
    act("end", &GainsView::endRequested);
    act("files", &GainsView::pressFilesRequested);
    act("demo", &GainsView::demoRequested);
    base::keepTranslated(this, &GainsView::retranslate);
    base::onChange(this, &GainsView::refresh, {QEvent::PaletteChange});
}

void GainsView::resizeEvent(QResizeEvent* event) {
    CalibrationView::resizeEvent(event);
    // Beside each other where that makes them larger.
    const QSize room = m_pictures->geometry().size();
    m_pictures->setDirection(room.width() > kWide * room.height() ? QBoxLayout::LeftToRight
                                                                  : QBoxLayout::TopToBottom);
}

QWidget* GainsView::makeSteps() {
    auto* page = new QWidget(this);
    auto* layout = new QVBoxLayout(page);
    layout->setContentsMargins(0, 0, 0, 0);
    for (QLabel* text : {m_tareText, m_pressText, m_loadText})
        text->setWordWrap(true);
    const auto add = [&](std::initializer_list<const char*> names) {
        auto* row = new QHBoxLayout;
        for (const char* name : names) {
            QPushButton* made = addButton(name, page);
            made->setMinimumHeight(base::em(this, 2.2));
            row->addWidget(made);
        }
        row->addStretch(1);
        layout->addLayout(row);
        layout->addSpacing(base::grid(this));
    };
    layout->addWidget(m_tareText);
    add({"tare"});
    layout->addWidget(m_pressText);
    add({"collect", "end", "files", "demo"});
    layout->addWidget(m_loadText);
    layout->addWidget(m_uneven);
    layout->addWidget(m_progress);
    layout->addSpacing(base::grid(this));
    layout->addWidget(verdict());
    layout->addStretch(1);
    return page;
}

void GainsView::setLivePicture(QWidget* picture) {
    share(picture);
    m_pictures->insertWidget(0, picture, 1);
}

void GainsView::setUnevenness(const std::optional<equilibration::Unevenness>& unevenness) {
    const auto inPercent = [](double value) { return std::optional(100.0 * value); };
    bool changed = m_isUneven != unevenness.has_value();
    m_isUneven = unevenness.has_value();
    changed |= m_with.update(unevenness ? inPercent(unevenness->withGains) : std::nullopt);
    changed |= m_without.update(unevenness ? inPercent(unevenness->without) : std::nullopt);
    if (changed)
        showUnevenness();
}

void GainsView::showUnevenness() {
    const QString with = m_with.text().trimmed();
    const QString without = m_without.text().trimmed();
    m_uneven->setText(
        !m_isUneven ? QString()
        : m_calibration.gains
            ? tr("The taxels differ by %1 % without gains, by %2 % with them.").arg(without, with)
            : tr("The taxels differ by %1 % under this load.").arg(without));
}

void GainsView::setFacts(const ArrayFacts& facts) {
    if (std::exchange(m_facts, facts) != facts)
        refresh();
}

void GainsView::setCalibration(const GainCalibration& calibration, bool isSaved) {
    m_trouble.clear();
    m_calibration = calibration;
    forgetChanges(isSaved);
    refresh();
}

void GainsView::take(const GainCalibration& calibration) {
    m_trouble.clear();
    change([this, calibration] { apply(calibration); }, [this, before = m_calibration] { apply(before); });
}

void GainsView::apply(const GainCalibration& calibration) {
    m_trouble.clear();
    m_calibration = calibration;
    refresh();
    emit calibrationChanged(calibration);
}

void GainsView::undo() {
    if (!m_pressing && !m_busy)
        changes().undo();
}

void GainsView::redo() {
    if (!m_pressing && !m_busy)
        changes().redo();
}

void GainsView::setProgress(const std::optional<PressProgress>& progress) {
    if (progress)
        m_progress->setValue(static_cast<int>(
            kProgressSteps * std::clamp(progress->collected_s / progress->wanted_s, 0.0, 1.0)));
    const bool changed = progress.has_value() != m_pressing.has_value() ||
                         (progress && progress->waiting != m_pressing->waiting);
    m_pressing = progress;
    if (changed)
        refresh();
}

void GainsView::setBusy(bool busy) {
    m_busy = busy;
    if (busy)
        m_trouble.clear();
    refresh();
}

void GainsView::showTrouble(const QString& text) {
    m_trouble = text;
    refresh();
}

StepReading GainsView::step() const {
    if (m_pressing)
        return {.state = StepState::running, .share = m_pressing->collected_s / m_pressing->wanted_s};
    if (m_busy)
        return {.state = StepState::running};
    // What could be lost counts before what went wrong, which the page says.
    if (!isSaved())
        return {.state = StepState::notSaved};
    if (!m_trouble.isEmpty())
        return {.state = StepState::failed};
    return {.state = m_calibration.gains ? StepState::done : StepState::toDo};
}

QString GainsView::describeGains() const {
    if (!m_calibration.gains)
        return {};
    const TaxelGains& gains = *m_calibration.gains;
    const std::optional<equilibration::GainRange> range = gains.range();
    QStringList lines;
    if (range)
        lines << tr("%1 of %2 taxels have gains from %3 to %4.")
                     .arg(gains.good())
                     .arg(gains.taxels.size())
                     .arg(base::fixedDigits(range->least, 2), base::fixedDigits(range->greatest, 2));
    if (range && range->largestError > 0.0)
        lines << tr("The least certain gain has a standard error of %1 %.")
                     .arg(percent(range->largestError, 2));
    QStringList left;
    if (const int dead = countOf(gains, TaxelState::dead))
        left << tr("%n dead", "taxels", dead);
    if (const int weak = countOf(gains, TaxelState::weak))
        left << tr("%n too weak", "taxels", weak);
    if (const int strong = countOf(gains, TaxelState::strong))
        left << tr("%n too strong", "taxels", strong);
    if (const int stuck = countOf(gains, TaxelState::stuck))
        left << tr("%n stuck", "taxels", stuck);
    if (!left.isEmpty())
        lines << tr("Not used: %1.", "kinds of taxels").arg(left.join(QStringLiteral(", ")));
    if (gains.presses > 1)
        lines << tr("Gains vary by %1 % from press to press.").arg(percent(gains.repeatability, 2));
    if (gains.isTilted)
        lines << tr("The response changes by %1 % along x and %2 % along y: the load may have been uneven. "
                    "Turn the bladder or plate by 180\u00b0 and collect another press: the difference "
                    "cancels out.")
                     .arg(percent(gains.tilt_x, 0), percent(gains.tilt_y, 0));
    return lines.join(QLatin1Char('\n'));
}

void GainsView::refresh() {
    const bool open = !m_facts.name.isEmpty();
    const bool hasGains = m_calibration.gains != nullptr;
    showTitle(open ? m_facts.name : tr("No array"));
    const QString state = !open
                              ? tr("Open an array, a recording or a scene on the page Operate, or the demo.")
                          : m_busy    ? tr("computing the gains\u2026")
                          : !hasGains ? tr("no gains: every taxel counts as it is")
                          : isSaved() ? tr("gains in use, saved")
                                      : tr("gains in use, not saved");
    const base::StatusColours& status = base::statusColours(palette());
    showState(state,
              m_facts.simulated  ? base::Provenance::simulated
              : m_facts.recorded ? base::Provenance::recorded
                                 : base::Provenance::live,
              m_facts.simulated  ? status.simulated
              : open && hasGains ? status.live
                                 : status.stale);
    m_tareText->setText(m_facts.tared ? tr("1. The array is tared.")
                                      : tr("1. Tare the array with nothing touching it."));
    const int presses = static_cast<int>(m_calibration.presses.size());
    QString text =
        tr("2. Press evenly on the whole array, with a bladder or with a plate on foam. The load may "
           "change.");
    if (presses > 0)
        text += QLatin1Char(' ') + tr("%n press(es) so far.", nullptr, presses);
    m_pressText->setText(text);
    QString load;
    if (m_pressing)
        load = m_pressing->waiting
                   ? tr("Waiting for a load on more than half of the taxels: %1 of %2 now. If the array is "
                        "pressed already, it was tared under that load: take the load off and tare again.")
                   : tr("Keep pressing: %1 of %2 taxels are under load.");
    else if (open && m_facts.usable > 0)
        load = tr("%1 of %2 taxels are under load.");
    m_loadText->setText(load.isEmpty() ? load : load.arg(m_facts.loaded).arg(m_facts.usable));
    base::setTextColour(
        m_loadText, m_pressing && m_pressing->waiting ? status.stale : palette().color(QPalette::WindowText));
    m_progress->setVisible(m_pressing.has_value());
    verdict()->setText(m_trouble.isEmpty() ? describeGains() : m_trouble);
    base::setTextColour(verdict(), !m_trouble.isEmpty() ? status.lost
                                   : hasGains && m_calibration.gains->isTilted
                                       ? status.stale
                                       : palette().color(QPalette::WindowText));

    const bool idle = !m_pressing && !m_busy;
    enable("undo", idle && changes().canUndo());
    enable("redo", idle && changes().canRedo());
    enable("load", idle && open);
    enable("reset", idle && (hasGains || presses > 0));
    enable("save", idle && hasGains);
    enable("tare", (idle || (m_pressing && m_pressing->waiting)) && open);
    enable("collect", idle && open);
    enable("files", idle && open);
    button("collect")->setVisible(!m_pressing && open);
    button("end")->setVisible(m_pressing.has_value());
    button("files")->setVisible(open);
    button("demo")->setVisible(!open);
    m_map->setGains(m_calibration.gains);
    m_map->setVisible(hasGains);
    m_readout->setVisible(hasGains);
    m_readout->setText(m_map->readout());
    m_uneven->setVisible(open);
    showUnevenness();
}

void GainsView::retranslate() {
    name("undo", tr("Undo"), tr("Undo the last change (Ctrl+Z)"));
    name("redo", tr("Redo"), tr("Redo the change undone last"));
    name("load", tr("&Load\u2026"), tr("Load gains for an array of this size from a file (CSV)"));
    name("reset", tr("Rese&t"), tr("Use no gains and forget all presses"));
    name("save", tr("&Save\u2026"),
         tr("Save the gains to a file (CSV) for \u201cOpen recording\u201d, source lists and the command "
            "line"));
    name("tare", tr("Tare &now"),
         tr("Takes the mean of the next half second as the unloaded state. Nothing may touch the array."));
    name("collect", tr("&Collect a press"), tr("Wait for a load and collect its frames; stops by itself"));
    name("end", tr("&End"), tr("Use what has been collected"));
    name("files", tr("&Open recorded presses\u2026"),
         tr("Frames as CSV, one file per press: time_s,t0,t1,\u2026"));
    name("demo", tr("Open the &demo"),
         tr("A simulated plate presses evenly on an array whose taxels differ"));
    m_map->setAccessibleName(tr("Gains of the taxels"));
    m_map->setWhatsThis(tr("Red taxels read too low and are raised, blue ones are lowered, hatched ones are "
                           "not used. Point at a taxel, or use the arrow keys, to read its gain."));
    m_progress->setAccessibleName(tr("Share of the press that has been collected"));
    setAccessibleName(tr("Calibration of an array's taxels"));
    refresh();
}

} // namespace teleta::calibrate
