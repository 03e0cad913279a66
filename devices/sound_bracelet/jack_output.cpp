// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/sound_bracelet/jack_output.h"

#include "backend/core/failure.h"
#include "backend/core/steady_time.h"

#include <QCoreApplication>
#include <QString>
#include <QStringList>

#include <algorithm>
#include <chrono>
#include <optional>
#include <set>
#include <span>
#include <thread>
#include <utility>

namespace teleta::sound {

namespace {

struct JackText {
    Q_DECLARE_TR_FUNCTIONS(JackText)
};

/// More than any server takes at a time.
constexpr std::size_t kMostServerFrames = 65'536;
constexpr auto kLook = std::chrono::milliseconds(5);
/// Until the samples of a setpoint play: it waits for one period and plays in the next.
constexpr double kGraphPeriods = 1.0;

std::string clientOf(const std::string& port) {
    return port.substr(0, port.rfind(':'));
}

QString listed(const std::set<std::string>& names) {
    QStringList list;
    for (const std::string& name : names)
        list << QString::fromStdString(name);
    return list.isEmpty() ? JackText::tr("none") : list.join(QStringLiteral(", "));
}

core::Unexpected unavailable(const QString& message, const QString& expected = {}) {
    return core::failed(core::ErrorKind::unavailable, message, expected);
}

} // namespace

core::Expected<std::unique_ptr<JackOutput>> JackOutput::open(const SoundBraceletFile& file,
                                                             ToneEngine& engine) {
    const bool pipeWire = file.address.api == SoundApi::pipeWire;
    std::optional<core::Error> failure;
    for (const std::string& path : pipeWire ? pipeWireLibraries() : jackLibraries()) {
        auto jack = loadJack(path);
        if (!jack) {
            if (!failure)
                failure = jack.error();
            continue;
        }
        JackClient* client = jack->clientOpen(kBraceletClient, kJackNoStartServer, nullptr);
        if (client == nullptr) {
            failure = unavailable(pipeWire ? JackText::tr("PipeWire is not running.")
                                           : JackText::tr("The JACK server is not running."))
                          .value();
            continue;
        }
        std::unique_ptr<JackOutput> output(new JackOutput(file, engine, std::move(*jack), client));
        TELETA_CHECK(output->start());
        return output;
    }
    return core::Unexpected(*failure);
}

JackOutput::JackOutput(const SoundBraceletFile& file, ToneEngine& engine, JackLibrary jack,
                       JackClient* client)
    : m_file(file)
    , m_engine(engine)
    , m_jack(std::move(jack))
    , m_client(client)
    , m_unheard(kMostServerFrames) {
}

JackOutput::~JackOutput() {
    if (m_active)
        m_jack.deactivate(m_client);
    m_jack.clientClose(m_client);
}

core::Expected<void> JackOutput::start() {
    const std::uint32_t rate_Hz = m_jack.sampleRate(m_client);
    if (rate_Hz != m_file.sampleRate_Hz)
        return core::refused(JackText::tr("The sound server plays %1 samples a second.").arg(rate_Hz),
                             JackText::tr("sample_rate_Hz = %1 in the device file").arg(rate_Hz));
    TELETA_CHECK(findOutputs());
    if (!m_file.shared && isShared())
        return core::refused(JackText::tr("Another program plays on %1.").arg(QString::fromStdString(m_card)),
                             JackText::tr("it to be disconnected, or shared = true in the device file"));
    TELETA_CHECK(registerPorts());
    setCallbacks();
    // Also where it is the period already: PipeWire would change it when another program comes.
    (void)m_jack.setBufferSize(m_client, m_file.period_frames);
    if (m_jack.activate(m_client) != 0)
        return unavailable(JackText::tr("The sound server did not activate the connection."));
    m_active = true;
    TELETA_CHECK(connectPorts());
    TELETA_CHECK(awaitPeriod());
    readLatency();
    m_playing.store(true, std::memory_order_release);
    m_changed.store(true, std::memory_order_release);
    return {};
}

core::Expected<void> JackOutput::findOutputs() {
    const std::string& wanted = m_file.address.name;
    std::string card;
    std::set<std::string> others;
    for (const bool physical : {true, false}) {
        const unsigned long flags = kJackPortIsInput | (physical ? kJackPortIsPhysical : 0);
        for (const std::string& port : m_jack.names(m_jack.ports(m_client, nullptr, kJackAudio, flags))) {
            const std::vector<std::string> names = namesOf(port);
            others.insert(names.front());
            if (card.empty() && std::ranges::find(names, wanted) != names.end())
                card = names.front();
        }
        // Without a name only a card counts, no program that listens.
        if (wanted.empty()) {
            if (others.size() == 1)
                card = *others.begin();
            break;
        }
    }
    if (card.empty() && wanted.empty() && !others.empty())
        return core::refused(JackText::tr("There are several sound cards: %1.").arg(listed(others)),
                             JackText::tr("the name of one of them in device"));
    if (card.empty())
        return unavailable(
            wanted.empty()
                ? JackText::tr("There is no sound card.")
                : JackText::tr("There is no sound output \"%1\".").arg(QString::fromStdString(wanted)),
            JackText::tr("one of: %1").arg(listed(others)));
    for (const std::string& port :
         m_jack.names(m_jack.ports(m_client, nullptr, kJackAudio, kJackPortIsInput)))
        if (clientOf(port) == card)
            m_cardPorts.push_back(port);
    m_card = card;
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        if (m_file.channels[i] > m_cardPorts.size())
            return core::refused(
                JackText::tr("\"%1\" has %n output(s).", nullptr, static_cast<int>(m_cardPorts.size()))
                    .arg(QString::fromStdString(card)),
                JackText::tr("an output %1, as channels says").arg(m_file.channels[i]));
        m_targets[i] = m_cardPorts[m_file.channels[i] - 1];
    }
    return {};
}

/// The client of a port, and what else it is called.
std::vector<std::string> JackOutput::namesOf(const std::string& port) const {
    std::vector<std::string> names{clientOf(port)};
    const JackPort* handle = m_jack.portByName(m_client, port.c_str());
    if (handle == nullptr)
        return names;
    const auto size = static_cast<std::size_t>(std::max(m_jack.portNameSize(), 1));
    std::string first(size, '\0');
    std::string second(size, '\0');
    char* const aliases[2] = {first.data(), second.data()};
    const int known = m_jack.portAliases(handle, aliases);
    if (known > 0)
        names.push_back(clientOf(first.c_str()));
    if (known > 1)
        names.push_back(clientOf(second.c_str()));
    return names;
}

core::Expected<void> JackOutput::registerPorts() {
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        const std::string name = "tactor_" + std::to_string(i + 1);
        m_ports[i] = m_jack.portRegister(m_client, name.c_str(), kJackAudio,
                                         kJackPortIsOutput | kJackPortIsTerminal, 0);
        if (m_ports[i] == nullptr)
            return unavailable(JackText::tr("The sound server refused to create a port for a tactor."));
        m_portNames[i] = m_jack.portName(m_ports[i]);
    }
    return {};
}

void JackOutput::setCallbacks() {
    m_jack.onShutdown(m_client, ended, this);
    m_jack.setProcess(m_client, process, this);
    m_jack.setRateCallback(m_client, rateChanged, this);
    m_jack.setXrunCallback(m_client, missedPeriod, this);
    m_jack.setConnectCallback(m_client, connectionsChanged, this);
}

core::Expected<void> JackOutput::connectPorts() {
    for (std::size_t i = 0; i < core::kTactors; ++i)
        if (m_jack.connect(m_client, m_portNames[i].c_str(), m_targets[i].c_str()) != 0)
            return unavailable(JackText::tr("Tactor %1 cannot be connected to %2.")
                                   .arg(i + 1)
                                   .arg(QString::fromStdString(m_targets[i])));
    return {};
}

/// A server takes up the period with its next cycles, if it does.
core::Expected<void> JackOutput::awaitPeriod() {
    const std::int64_t end_ns = core::steadyNow_ns() + kLongestOpening_ns;
    while (m_engine.fault() == SoundFault::none) {
        if (m_engine.frames() == m_file.period_frames && isConnected())
            return {};
        if (core::steadyNow_ns() >= end_ns)
            break;
        std::this_thread::sleep_for(kLook);
    }
    if (const SoundFault fault = m_engine.fault(); fault != SoundFault::none)
        return unavailable(QString::fromStdString(describe(fault)));
    if (m_engine.called_ns() == 0)
        return unavailable(JackText::tr("The sound server requests no samples."));
    return core::refused(
        JackText::tr("The sound server plays %1 samples at a time.").arg(m_engine.frames()),
        JackText::tr("period_frames = %1 in the device file, or a server that plays %2 at a time")
            .arg(m_engine.frames())
            .arg(m_file.period_frames));
}

void JackOutput::readLatency() {
    std::uint32_t most_frames = 0;
    for (JackPort* port : m_ports) {
        JackLatencyRange range;
        m_jack.latencyRange(port, kJackPlaybackLatency, &range);
        most_frames = std::max(most_frames, range.most_frames);
    }
    m_statedLatency_s =
        m_file.period_s() * (kGraphPeriods + 1.0) + static_cast<double>(most_frames) / m_file.sampleRate_Hz;
}

void JackOutput::check() {
    if (!m_changed.exchange(false, std::memory_order_acq_rel))
        return;
    if (!isConnected())
        m_engine.fail(SoundFault::disconnected);
    else if (!m_file.shared && isShared())
        m_engine.fail(SoundFault::sharedWithOthers);
}

/// Each tactor to its output and nothing else.
bool JackOutput::isConnected() const {
    for (std::size_t i = 0; i < core::kTactors; ++i)
        if (m_jack.names(m_jack.connectionsOf(m_client, m_ports[i])) != std::vector{m_targets[i]})
            return false;
    return true;
}

bool JackOutput::isShared() const {
    return std::ranges::any_of(m_cardPorts, [this](const std::string& output) {
        const JackPort* port = m_jack.portByName(m_client, output.c_str());
        if (port == nullptr)
            return false;
        const std::vector<std::string> sources = m_jack.names(m_jack.connectionsOf(m_client, port));
        return std::ranges::any_of(sources, [this](const std::string& source) {
            return std::ranges::find(m_portNames, source) == m_portNames.end();
        });
    });
}

int JackOutput::process(std::uint32_t frames, void* self) {
    auto& output = *static_cast<JackOutput*>(self);
    const std::int64_t now_ns = core::steadyNow_ns();
    if (frames != output.m_file.period_frames && output.m_playing.load(std::memory_order_acquire))
        output.m_engine.fail(SoundFault::periodChanged);
    output.countMissedPeriods(frames);
    ToneEngine::Outputs outputs;
    for (std::size_t i = 0; i < core::kTactors; ++i) {
        auto* const samples = static_cast<float*>(output.m_jack.portBuffer(output.m_ports[i], frames));
        // While a port is connected, or its server ends, it may have none.
        outputs[i] =
            samples != nullptr
                ? std::span(samples, frames)
                : std::span(output.m_unheard).first(std::min<std::size_t>(frames, kMostServerFrames));
    }
    output.m_engine.render(outputs, now_ns);
    return 0;
}

/// A server does not tell each one: PipeWire leaves out the first.
void JackOutput::countMissedPeriods(std::uint32_t frames) {
    const std::uint32_t begin = m_jack.frameTime(m_client);
    const bool told = m_told.exchange(false, std::memory_order_acq_rel);
    if (m_nextFrame && begin != *m_nextFrame && !told && m_playing.load(std::memory_order_acquire))
        m_engine.missPeriod();
    m_nextFrame = begin + frames;
}

int JackOutput::rateChanged(std::uint32_t rate_Hz, void* self) {
    auto& output = *static_cast<JackOutput*>(self);
    if (rate_Hz != output.m_file.sampleRate_Hz)
        output.m_engine.fail(SoundFault::rateChanged);
    return 0;
}

int JackOutput::missedPeriod(void* self) {
    auto& output = *static_cast<JackOutput*>(self);
    output.m_told.store(true, std::memory_order_release);
    output.m_engine.missPeriod();
    return 0;
}

void JackOutput::connectionsChanged(std::uint32_t, std::uint32_t, int, void* self) {
    auto& output = *static_cast<JackOutput*>(self);
    // Also while the connections are made: check() looks at them only after that.
    output.m_changed.store(true, std::memory_order_release);
}

void JackOutput::ended(void* self) {
    static_cast<JackOutput*>(self)->m_engine.fail(SoundFault::serverGone);
}

} // namespace teleta::sound
