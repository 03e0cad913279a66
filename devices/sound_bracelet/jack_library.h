// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "backend/core/error.h"

#include <cstdint>
#include <string>
#include <vector>

namespace teleta::sound {

/// Of the JACK library, whose headers are not needed: the few functions are declared here as jack/jack.h
/// does.
struct JackClient;
struct JackPort;

struct JackLatencyRange {
    std::uint32_t least_frames = 0;
    std::uint32_t most_frames = 0;
};

/// Name of the client that plays on a bracelet; its ports have it before a colon.
inline constexpr const char* kBraceletClient = "TeleTA bracelet";
inline constexpr const char* kJackAudio = "32 bit float mono audio";
inline constexpr int kJackNoStartServer = 0x01;
inline constexpr unsigned long kJackPortIsInput = 0x1;
inline constexpr unsigned long kJackPortIsOutput = 0x2;
inline constexpr unsigned long kJackPortIsPhysical = 0x4;
inline constexpr unsigned long kJackPortIsTerminal = 0x10;
inline constexpr int kJackCaptureLatency = 0;
inline constexpr int kJackPlaybackLatency = 1;

/// The functions of a JACK library that was loaded at run time: PipeWire's or JACK's own. It stays loaded.
/// Thread: any.
struct JackLibrary {
    JackClient* (*clientOpen)(const char* name, int options, int* status, ...) = nullptr;
    int (*clientClose)(JackClient*) = nullptr;
    int (*activate)(JackClient*) = nullptr;
    int (*deactivate)(JackClient*) = nullptr;
    const char* (*clientName)(JackClient*) = nullptr;
    void (*onShutdown)(JackClient*, void (*)(void*), void*) = nullptr;
    int (*setProcess)(JackClient*, int (*)(std::uint32_t frames, void*), void*) = nullptr;
    int (*setRateCallback)(JackClient*, int (*)(std::uint32_t rate_Hz, void*), void*) = nullptr;
    int (*setXrunCallback)(JackClient*, int (*)(void*), void*) = nullptr;
    int (*setConnectCallback)(JackClient*, void (*)(std::uint32_t, std::uint32_t, int, void*),
                              void*) = nullptr;
    int (*setBufferSize)(JackClient*, std::uint32_t frames) = nullptr;
    std::uint32_t (*sampleRate)(JackClient*) = nullptr;
    std::uint32_t (*bufferSize)(JackClient*) = nullptr;
    std::uint32_t (*frameTime)(const JackClient*) = nullptr; ///< at which this period began; wraps
    JackPort* (*portRegister)(JackClient*, const char* name, const char* type, unsigned long flags,
                              unsigned long bufferSize) = nullptr;
    void* (*portBuffer)(JackPort*, std::uint32_t frames) = nullptr;
    const char* (*portName)(const JackPort*) = nullptr;
    int (*portAliases)(const JackPort*, char* const aliases[2]) = nullptr;
    int (*portNameSize)() = nullptr;
    JackPort* (*portByName)(JackClient*, const char* name) = nullptr;
    const char** (*ports)(JackClient*, const char* namePattern, const char* typePattern,
                          unsigned long flags) = nullptr;
    const char** (*connectionsOf)(const JackClient*, const JackPort*) = nullptr;
    int (*connect)(JackClient*, const char* from, const char* to) = nullptr;
    void (*latencyRange)(JackPort*, int mode, JackLatencyRange*) = nullptr;
    void (*free)(void*) = nullptr;
    void (*setErrorText)(void (*)(const char*)) = nullptr;
    void (*setInfoText)(void (*)(const char*)) = nullptr;

    /// A list of names that the library allocated, null for none; frees it.
    [[nodiscard]] std::vector<std::string> names(const char** list) const;
};

/// Paths under which PipeWire's own library and the system's may lie, best first.
[[nodiscard]] std::vector<std::string> pipeWireLibraries();
[[nodiscard]] std::vector<std::string> jackLibraries();

/// Error: unavailable, there is no such library, or it lacks a function.
[[nodiscard]] core::Expected<JackLibrary> loadJack(const std::string& path);

} // namespace teleta::sound
