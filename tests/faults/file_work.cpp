// SPDX-License-Identifier: GPL-3.0-or-later
// Writes files as the programs do, for tests that make this fail:
//   file_work recording FOLDER    a recording of some transactions
//   file_work study FOLDER        a study of one participant with some trials
//   file_work output FOLDER       replaces the file "result" some times
// After each step that is promised to last, "FOLDER/acks" gets one byte more. Exit code: 0 done, 1 a step
// failed and its error was told.
#include "tests/faults/file_work.h"

#include "backend/core/data/output_file.h"
#include "backend/recording/recording_writer.h"
#include "backend/study/store/study_store.h"
#include "tests/backend/study/small_protocol.h"

#include <QCoreApplication>

#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <string_view>
#include <unistd.h>
#include <utility>
#include <vector>

namespace {

using namespace teleta;

class Acks {
public:
    explicit Acks(const std::string& folder)
        : m_file(open((folder + "/acks").c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600)) {}
    ~Acks() { close(m_file); }
    Acks(const Acks&) = delete;
    Acks& operator=(const Acks&) = delete;
    void add() const { (void)!write(m_file, ".", 1); }

private:
    int m_file;
};

core::Expected<void> record(const std::string& folder, const Acks& acks) {
    recording::RecordingWriter writer(
        folder + "/r.teleta", [] { return test::workTime(); }, true);
    TELETA_CHECK(
        writer.begin({.appVersion = "1", .scene = {}, .sceneText = {}, .configuration = {}, .start_ns = 0}));
    recording::StreamInfo info;
    info.name = "frames";
    info.shape = {4, 4};
    TELETA_CHECK(writer.addStream(info));
    for (int step = 0; step < test::kSteps; ++step) {
        core::TappedFrames frames;
        for (int k = 0; k < test::kFramesAStep; ++k) {
            frames.time_ns.push_back((step * test::kFramesAStep + k) * 5'000'000LL);
            frames.sourceTime_s.push_back(0.0);
        }
        const std::vector<float> values(test::kFramesAStep * 16, static_cast<float>(step));
        frames.values.resize(values.size() * sizeof(float));
        std::memcpy(frames.values.data(), values.data(), frames.values.size());
        writer.take(0, std::move(frames));
        TELETA_CHECK(writer.commit());
        acks.add();
    }
    TELETA_CHECK(writer.finish());
    acks.add();
    return {};
}

core::Expected<void> keepTrials(const std::string& folder, const Acks& acks) {
    study::StudyHead head;
    head.protocol = study::smallProtocol();
    head.created = test::workTime();
    TELETA_TRY(auto store, study::StudyStore::create({folder + "/study"}, head));
    TELETA_TRY(const auto participant, store.enrol("P1"));
    const auto plan = study::planSessions(head.protocol, head.seed, participant.enrolment);
    TELETA_TRY(const auto session, store.beginSession(participant, 0, plan.front(), test::workTime()));
    for (int step = 0; step < test::kSteps; ++step) {
        study::TrialResult result;
        result.planned.phase = study::Phase::test;
        result.planned.trial = static_cast<std::size_t>(step) + 1;
        result.trialInBlock = result.planned.trial;
        result.response = 0;
        result.responseTime_s = 1.0 + step;
        TELETA_CHECK(store.keepTrial(session, result, test::workTime()));
        acks.add();
    }
    return {};
}

core::Expected<void> replaceFile(const std::string& folder, const Acks& acks) {
    for (int step = 0; step < test::kOutputs; ++step) {
        TELETA_CHECK(core::writeFile(folder + "/result", test::outputOf(step)));
        acks.add();
    }
    return {};
}

} // namespace

int main(int argc, char** argv) {
    QCoreApplication application(argc, argv);
    if (argc != 3)
        return 2;
    const std::string_view kind = argv[1];
    const Acks acks(argv[2]);
    const core::Expected<void> done = kind == "recording" ? record(argv[2], acks)
                                      : kind == "study"   ? keepTrials(argv[2], acks)
                                                          : replaceFile(argv[2], acks);
    if (done)
        return 0;
    std::fprintf(stderr, "%s\n", core::describe(done.error()).c_str());
    return done.error().message.empty() ? 2 : 1;
}
