// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/sound_bracelet/jack_library.h"

#include "backend/core/failure.h"

#include <QCoreApplication>

#include <dlfcn.h>

namespace teleta::sound {

namespace {

void ignoreText(const char*) {
}

struct Loader {
    void* library;
    const char* missing = nullptr;

    template <typename Function>
    void find(Function*& function, const char* name) {
        function = reinterpret_cast<Function*>(dlsym(library, name));
        if (function == nullptr && missing == nullptr)
            missing = name;
    }
};

} // namespace

std::vector<std::string> JackLibrary::names(const char** list) const {
    std::vector<std::string> names;
    if (list == nullptr)
        return names;
    for (const char** name = list; *name != nullptr; ++name)
        names.emplace_back(*name);
    free(list);
    return names;
}

// With their whole paths: both libraries call themselves libjack.so.0, and the loader would take one that is
// loaded for the other.
std::vector<std::string> pipeWireLibraries() {
    return {TELETA_LIBRARY_FOLDER "/pipewire-0.3/jack/libjack.so.0", TELETA_LIBRARY_FOLDER "/libjack.so.0",
            "libjack.so.0"};
}

std::vector<std::string> jackLibraries() {
    return {TELETA_LIBRARY_FOLDER "/libjack.so.0", "libjack.so.0",
            TELETA_LIBRARY_FOLDER "/pipewire-0.3/jack/libjack.so.0"};
}

core::Expected<JackLibrary> loadJack(const std::string& path) {
    const auto failed = [](const char* why) {
        return core::failed(
            core::ErrorKind::unavailable,
            QCoreApplication::translate("SoundBracelet", "There is no JACK library: %1")
                .arg(QString::fromLocal8Bit(why)),
            QCoreApplication::translate("SoundBracelet", "the package pipewire-jack, or libjack-jackd2-0"));
    };
    // It stays: its threads may outlive the last client.
    Loader loader{dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE)};
    if (loader.library == nullptr)
        return failed(dlerror());
    JackLibrary jack{};
    loader.find(jack.clientOpen, "jack_client_open");
    loader.find(jack.clientClose, "jack_client_close");
    loader.find(jack.activate, "jack_activate");
    loader.find(jack.deactivate, "jack_deactivate");
    loader.find(jack.clientName, "jack_get_client_name");
    loader.find(jack.onShutdown, "jack_on_shutdown");
    loader.find(jack.setProcess, "jack_set_process_callback");
    loader.find(jack.setRateCallback, "jack_set_sample_rate_callback");
    loader.find(jack.setXrunCallback, "jack_set_xrun_callback");
    loader.find(jack.setConnectCallback, "jack_set_port_connect_callback");
    loader.find(jack.setBufferSize, "jack_set_buffer_size");
    loader.find(jack.sampleRate, "jack_get_sample_rate");
    loader.find(jack.bufferSize, "jack_get_buffer_size");
    loader.find(jack.frameTime, "jack_last_frame_time");
    loader.find(jack.portRegister, "jack_port_register");
    loader.find(jack.portBuffer, "jack_port_get_buffer");
    loader.find(jack.portName, "jack_port_name");
    loader.find(jack.portAliases, "jack_port_get_aliases");
    loader.find(jack.portNameSize, "jack_port_name_size");
    loader.find(jack.portByName, "jack_port_by_name");
    loader.find(jack.ports, "jack_get_ports");
    loader.find(jack.connectionsOf, "jack_port_get_all_connections");
    loader.find(jack.connect, "jack_connect");
    loader.find(jack.latencyRange, "jack_port_get_latency_range");
    loader.find(jack.free, "jack_free");
    loader.find(jack.setErrorText, "jack_set_error_function");
    loader.find(jack.setInfoText, "jack_set_info_function");
    if (loader.missing != nullptr)
        return failed((path + ": " + loader.missing).c_str());
    // Its own texts would go to the terminal, in the middle of a table.
    jack.setErrorText(ignoreText);
    jack.setInfoText(ignoreText);
    return jack;
}

} // namespace teleta::sound
