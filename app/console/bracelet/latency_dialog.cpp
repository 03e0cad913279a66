// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/console/bracelet/latency_dialog.h"

#include "devices/sound_bracelet/latency/click_listener.h"
#include "devices/sound_bracelet/latency/sound_latency_file.h"
#include "widgets/base/background.h"
#include "widgets/base/compose.h"
#include "widgets/base/numbers/quantity_text.h"
#include "widgets/base/on_change.h"
#include "widgets/base/theme.h"
#include "widgets/calibrate/latency_chart.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace teleta::console {

namespace {

constexpr int kTick_ms = 33;

QString milliseconds(double time_s) {
    return base::fixedDigits(1e3 * time_s, 1);
}

} // namespace

LatencyDialog::LatencyDialog(BraceletService& station, QWidget* parent)
    : QDialog(parent)
    , m_station(station)
    , m_deviceFile(station.deviceFile())
    , m_what(new QLabel)
    , m_inputName(new QLabel)
    , m_input(base::named<QComboBox>("input"))
    , m_again(base::named<QPushButton>("again"))
    , m_chart(new calibrate::LatencyChart)
    , m_progress(base::named<QProgressBar>("progress"))
    , m_result(base::named<QLabel>("result"))
    , m_trouble(base::named<QLabel>("trouble"))
    , m_measure(base::named<QPushButton>("measure"))
    , m_save(base::named<QPushButton>("save")) {
    m_inputName->setBuddy(m_input);
    m_input->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_input->setMinimumContentsLength(24);
    m_progress->setRange(0, sound::kClicks);
    m_progress->setFormat(QStringLiteral("%v / %m"));
    for (QLabel* text : {m_what, m_result, m_trouble}) {
        text->setWordWrap(true);
        text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    buttons->addButton(m_save, QDialogButtonBox::ActionRole);
    m_measure->setDefault(true);
    auto* where = new QHBoxLayout;
    where->addWidget(m_inputName);
    where->addWidget(m_input, 1);
    where->addWidget(m_again);
    auto* act = new QHBoxLayout;
    act->addWidget(m_measure);
    act->addWidget(m_progress, 1);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_what);
    layout->addLayout(where);
    layout->addLayout(act);
    layout->addWidget(m_chart, 1);
    layout->addWidget(m_result);
    layout->addWidget(m_trouble);
    layout->addWidget(buttons);
    m_what->setMinimumWidth(base::em(this, 36));

    connect(buttons, &QDialogButtonBox::rejected, this, &LatencyDialog::reject);
    connect(m_again, &QPushButton::clicked, this, &LatencyDialog::findInputs);
    connect(m_measure, &QPushButton::clicked, this, &LatencyDialog::measureOrStop);
    connect(m_save, &QPushButton::clicked, this, &LatencyDialog::save);
    connect(&m_station, &BraceletService::chosen, this, &LatencyDialog::onSession);
    connect(&m_clock, &QTimer::timeout, this, &LatencyDialog::tick);
    m_clock.start(kTick_ms);
    setTexts();
    restyle();
    base::onChange(this, &LatencyDialog::setTexts, {QEvent::LanguageChange});
    base::onChange(this, &LatencyDialog::restyle, {QEvent::PaletteChange});
    findInputs();
}

LatencyDialog::~LatencyDialog() {
    if (!m_run)
        return;
    m_run->stop.request_stop();
    m_run->end.wait();
}

void LatencyDialog::setTexts() {
    setWindowTitle(tr("Latency of the bracelet"));
    m_what->setText(
        tr("Ten clicks are played on tactor 1 and heard at an input of the sound card: fix an accelerometer "
           "to the tactor, or lead a cable from its output to the input. The median is saved in the device "
           "file, and studies then count from when a stimulus is felt."));
    m_inputName->setText(tr("&Input:"));
    m_again->setText(tr("&Look again"));
    m_save->setText(tr("&Save in the device file"));
    tick();
}

void LatencyDialog::findInputs() {
    m_busy = true;
    showTrouble({});
    base::runInBackground(
        this,
        [path = m_deviceFile.toStdString()]() -> core::Expected<std::vector<std::string>> {
            TELETA_TRY(const auto file, sound::readSoundBracelet(path));
            return sound::ClickListener::inputs(file);
        },
        [this](const core::Expected<std::vector<std::string>>& inputs) {
            m_busy = false;
            const QString before = m_input->currentText();
            m_input->clear();
            if (!inputs) {
                showTrouble(QString::fromStdString(core::describe(inputs.error())));
            } else {
                for (const std::string& input : *inputs)
                    m_input->addItem(QString::fromStdString(input));
                m_input->setCurrentIndex(std::max(0, m_input->findText(before)));
                if (inputs->empty())
                    showTrouble(tr("The sound server has no input."));
            }
            tick();
        });
    tick();
}

void LatencyDialog::measureOrStop() {
    if (m_run)
        m_run->stop.request_stop();
    else
        measure();
}

void LatencyDialog::measure() {
    auto session = m_station.session();
    if (!session || !m_station.isFree())
        return;
    showTrouble({});
    m_latency.reset();
    m_run = std::make_shared<Run>();
    auto work = [session = std::move(session), run = m_run, path = m_deviceFile.toStdString(),
                 input = m_input->currentText().toStdString()]() mutable {
        std::vector<double> clicks_s;
        const sound::LatencyWatch watch{.goesOn = [&] { return !run->stop.stop_requested(); },
                                        .heard =
                                            [&](double latency_s) {
                                                clicks_s.push_back(latency_s);
                                                run->clicks_s.set(clicks_s);
                                            }};
        auto latency = sound::readSoundBracelet(path).and_then([&](const sound::SoundBraceletFile& file) {
            return sound::measureSoundLatency(file, session->source(), session->player(), input, watch);
        });
        session.reset();
        run->ended.set_value();
        return latency;
    };
    base::runInBackground(this, std::move(work), [this](const core::Expected<sound::SoundLatency>& latency) {
        takeResult(latency);
    });
    tick();
}

void LatencyDialog::takeResult(const core::Expected<sound::SoundLatency>& latency) {
    m_chart->setClicks(m_run->clicks_s.get(), sound::kClicks);
    m_run.reset();
    m_saved = false;
    if (latency)
        m_latency = *latency;
    else if (latency.error().kind != core::ErrorKind::cancelled)
        showTrouble(QString::fromStdString(core::describe(latency.error())));
    tick();
    if (m_latency)
        m_save->setFocus();
}

void LatencyDialog::save() {
    if (!m_latency || m_busy)
        return;
    m_busy = true;
    showTrouble({});
    base::runInBackground(
        this,
        [path = m_deviceFile.toStdString(), latency = *m_latency] {
            return sound::keepLatency(path, latency);
        },
        [this](const core::Expected<void>& kept) {
            m_busy = false;
            m_saved = kept.has_value();
            if (!kept)
                showTrouble(QString::fromStdString(core::describe(kept.error())));
            else if (m_station.deviceFile() == m_deviceFile)
                m_station.choose(BraceletChoice::file, m_deviceFile); // reads it anew
            tick();
        });
    tick();
}

void LatencyDialog::onSession() {
    if (m_station.deviceFile() != m_deviceFile)
        reject();
}

void LatencyDialog::reject() {
    if (m_run)
        m_run->stop.request_stop();
    m_clock.stop();
    QDialog::reject();
}

/// What is possible, and how far a measurement is.
void LatencyDialog::tick() {
    // Whoever needs the bracelet has it.
    if (m_run && (m_station.isReserved() || m_station.isStopped()) && !m_run->stop.stop_requested()) {
        m_run->stop.request_stop();
        showTrouble(m_station.note());
    }
    if (m_run)
        m_chart->setClicks(m_run->clicks_s.get(), sound::kClicks);
    m_progress->setValue(static_cast<int>(m_chart->clicks_s().size()));
    m_input->setEnabled(!m_run && !m_busy);
    m_again->setEnabled(!m_run && !m_busy);
    m_measure->setText(m_run ? tr("S&top measuring") : tr("&Measure"));
    m_measure->setEnabled(m_run || (!m_busy && m_input->count() > 0 && m_station.isFree()));
    m_save->setEnabled(m_latency && !m_saved && !m_busy);
    m_result->setText(resultText());
}

QString LatencyDialog::resultText() const {
    if (m_run)
        return tr("Playing clicks. Do not touch the tactor or the input.");
    if (m_latency) {
        const QString found =
            tr("Median %1 ms, spread %2 ms from the shortest to the longest.")
                .arg(milliseconds(m_latency->median_s()), milliseconds(m_latency->spread_s()));
        return m_saved ? found + QLatin1Char(' ') +
                             tr("It is saved in %1.", "a file").arg(QFileInfo(m_deviceFile).fileName())
                       : found;
    }
    const auto& session = m_station.session();
    if (!session)
        return m_station.note();
    const core::BraceletDescription& bracelet = session->source().description();
    if (std::isfinite(bracelet.measuredLatency_s))
        return tr("The device file says %1 ms, as measured before.")
            .arg(milliseconds(bracelet.measuredLatency_s));
    return tr("Not measured yet. According to the sound server it is at most %1 ms.")
        .arg(milliseconds(bracelet.statedLatency_s));
}

void LatencyDialog::showTrouble(const QString& text) {
    m_trouble->setText(text);
    m_trouble->setVisible(!text.isEmpty());
}

void LatencyDialog::restyle() {
    base::setTextColour(m_trouble, base::statusColours(palette()).lost);
}

} // namespace teleta::console
