// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/faults/work_check.h"

#include "backend/recording/recording.h"
#include "backend/study/store/study_store.h"
#include "tests/backend/core/temporary_folder.h"
#include "tests/faults/file_work.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <sys/wait.h>
#include <unistd.h>

namespace teleta::test {

namespace {

namespace fs = std::filesystem;

/// Qt finds its database drivers through the application.
void makeApplication() {
    static int argc = 1;
    static std::array<char, 5> name{"test"};
    static std::array<char*, 2> argv{name.data(), nullptr};
    static const QCoreApplication kApplication(argc, argv.data());
}

std::string wrongWithRecording(const std::string& folder, int acks) {
    const auto recording = recording::Recording::open(folder + "/r.teleta");
    if (!recording)
        return acks == 0 ? std::string() : "cannot be opened: " + core::describe(recording.error());
    if (recording->streams().empty())
        return acks == 0 ? std::string() : "has no stream";
    recording::StreamReader reader = recording->reader(0);
    core::TappedFrames block;
    int frames = 0;
    for (;;) {
        const core::Expected<bool> next = reader.next(block);
        if (!next)
            return "cannot be read: " + core::describe(next.error());
        if (!*next)
            break;
        for (std::size_t k = 0; k < block.frames(); ++k, ++frames) {
            const auto values = recording::valuesOf<float>(block, k, 16);
            const float step = static_cast<float>(frames / kFramesAStep);
            if (!std::ranges::all_of(values, [step](float value) { return value == step; }))
                return "frame " + std::to_string(frames) + " is wrong";
        }
    }
    if (frames % kFramesAStep != 0)
        return "half a transaction is there";
    if (frames < std::min(acks, kSteps) * kFramesAStep)
        return "only " + std::to_string(frames) + " frames after " + std::to_string(acks) + " steps";
    return {};
}

std::string wrongWithStudy(const std::string& folder, int acks) {
    const auto store = study::StudyStore::open({folder + "/study"});
    if (!store)
        return acks == 0 ? std::string() : "cannot be opened: " + core::describe(store.error());
    std::size_t trials = 0;
    const auto participants = store->participants();
    if (!participants)
        return "cannot be read: " + core::describe(participants.error());
    for (const study::Participant& participant : *participants) {
        const auto sessions = store->sessions(participant);
        if (!sessions)
            return "cannot be read: " + core::describe(sessions.error());
        for (const study::SessionRecord& session : *sessions) {
            const auto kept = store->trials(session);
            if (!kept)
                return "cannot be read: " + core::describe(kept.error());
            for (const study::StoredTrial& trial : *kept)
                if (trial.result.responseTime_s != 1.0 + static_cast<double>(trials++))
                    return "trial " + std::to_string(trials) + " is wrong";
        }
    }
    if (trials < static_cast<std::size_t>(acks))
        return "only " + std::to_string(trials) + " trials after " + std::to_string(acks);
    return {};
}

std::string wrongWithOutput(const std::string& folder, int acks) {
    const std::string path = folder + "/result";
    if (!fs::exists(path))
        return acks == 0 ? std::string() : "is missing";
    const std::string text = readAll(path);
    for (int step = std::max(acks - 1, 0); step < kOutputs; ++step)
        if (text == outputOf(step))
            return {};
    return "is neither the old file nor the new one (" + std::to_string(text.size()) + " bytes)";
}

} // namespace

WorkResult runWork(const std::string& work, const std::string& folder,
                   const std::vector<std::pair<std::string, std::string>>& environment) {
    TemporaryFolder outside;
    const std::string errors = outside.path("errors");
    const pid_t child = fork();
    if (child == 0) {
        (void)!freopen(errors.c_str(), "w", stderr);
        setenv("LD_PRELOAD", TELETA_FAULTY_FILES, 1);
        setenv("FAULTY_ROOT", folder.c_str(), 1);
        for (const auto& [name, value] : environment)
            setenv(name.c_str(), value.c_str(), 1);
        execl(TELETA_FILE_WORK, "file_work", work.c_str(), folder.c_str(), nullptr);
        _exit(127);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), readAll(errors)};
}

int acksIn(const std::string& folder) {
    return fs::exists(folder + "/acks") ? static_cast<int>(readAll(folder + "/acks").size()) : 0;
}

std::string wrongWith(const std::string& work, const std::string& folder, int acks) {
    makeApplication();
    return work == "recording" ? wrongWithRecording(folder, acks)
           : work == "study"   ? wrongWithStudy(folder, acks)
                               : wrongWithOutput(folder, acks);
}

} // namespace teleta::test
