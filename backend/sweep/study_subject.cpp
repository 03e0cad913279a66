// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/input_file.h"
#include "backend/core/failure.h"
#include "backend/core/keys/toml_edit.h"
#include "backend/core/random_stream.h"
#include "backend/study/planning/identification_plan.h"
#include "backend/study/planning/study_truth.h"
#include "backend/study/planning/threshold_plan.h"
#include "backend/study/protocol/protocol.h"
#include "backend/study/protocol/trial_order.h"
#include "backend/sweep/subjects.h"

#include <QCoreApplication>
#include <QString>

#include <optional>

namespace teleta::sweep {

namespace {

constexpr double kAlpha = 0.05;
constexpr std::uint64_t kPlanSeed = 1;

struct StudySweepText {
    Q_DECLARE_TR_FUNCTIONS(StudySweep)
};

/// What its files say, and what is tested.
struct StudyTexts {
    std::string protocol, protocolFile;
    std::string truth, truthFile;
    std::string test;
    std::uint64_t participants = 0;
};

struct DrawnStudy {
    std::shared_ptr<const study::PossibleStudy> study;
    std::size_t participants = 0;
};

core::Expected<DrawnStudy> studyOf(const StudyTexts& texts, const CellSettings& settings) {
    CellSettings ofTruth, ofProtocol;
    DrawnStudy drawn{{}, static_cast<std::size_t>(texts.participants)};
    for (const auto& [key, value] : settings) {
        const long long* whole = std::get_if<long long>(&value);
        if (key == "participants" && whole != nullptr && *whole >= 1 && *whole <= 1000)
            drawn.participants = static_cast<std::size_t>(*whole);
        else if (key == "participants")
            return core::failed(core::ErrorKind::badInput,
                                StudySweepText::tr("\"participants\" is out of range"),
                                StudySweepText::tr("a whole number from 1 to 1000"));
        else if (key.starts_with("truth."))
            ofTruth.emplace_back(key.substr(6), value);
        else if (key.starts_with("protocol."))
            ofProtocol.emplace_back(key.substr(9), value);
        else
            return core::failed(
                core::ErrorKind::badInput,
                StudySweepText::tr("unknown key \"%1\"").arg(QString::fromStdString(key)),
                StudySweepText::tr("participants, or a key behind \"truth.\" or \"protocol.\""));
    }
    TELETA_TRY(const std::string protocolText,
               core::withTomlValues(texts.protocol, texts.protocolFile, ofProtocol));
    TELETA_TRY(const study::Protocol protocol, study::parseProtocol(protocolText, texts.protocolFile));
    TELETA_TRY(const std::string truthText, core::withTomlValues(texts.truth, texts.truthFile, ofTruth));
    TELETA_TRY(const study::StudyTruth truth, study::parseTruth(truthText, texts.truthFile));
    if (study::ThresholdPlan::isTest(texts.test)) {
        TELETA_TRY(study::ThresholdPlan plan, study::ThresholdPlan::make(protocol, truth, texts.test, {}));
        drawn.study = std::make_shared<study::ThresholdPlan>(std::move(plan));
    } else {
        TELETA_TRY(study::IdentificationPlan plan,
                   study::IdentificationPlan::make(protocol, truth, texts.test));
        drawn.study = std::make_shared<study::IdentificationPlan>(std::move(plan));
    }
    return drawn;
}

class StudyWorker : public SweepWorker {
public:
    explicit StudyWorker(StudyTexts texts)
        : m_texts(std::move(texts)) {}

    core::Expected<RunMeasures> run(const SweepPlan& plan, std::uint64_t cell, std::uint64_t seed,
                                    const std::function<void(const scene_run::LabelledFrame&)>&) override {
        if (!m_drawn.study || cell != m_cell) {
            TELETA_TRY(m_drawn, studyOf(m_texts, plan.settingsOf(cell)));
            m_cell = cell;
        }
        const std::uint64_t studySeed = study::derivedSeed(kPlanSeed, seed);
        std::vector<std::vector<double>> participants;
        for (std::size_t i = 0; i < m_drawn.participants; ++i) {
            core::RandomStream random(study::derivedSeed(studySeed, i));
            participants.push_back(m_drawn.study->participant(random));
        }
        const std::optional<double> p = m_drawn.study->p(participants);
        RunMeasures measures{{"significant", p && *p < kAlpha ? 1.0 : 0.0}, {"refused", p ? 0.0 : 1.0}};
        if (p)
            measures.emplace_back("p", *p);
        return measures;
    }

private:
    StudyTexts m_texts;
    DrawnStudy m_drawn; ///< of the cell
    std::uint64_t m_cell = 0;
};

class StudySubject : public SweepSubject {
public:
    explicit StudySubject(StudyTexts texts)
        : m_texts(std::move(texts)) {}

    [[nodiscard]] std::unique_ptr<SweepWorker> makeWorker() const override {
        return std::make_unique<StudyWorker>(m_texts);
    }
    [[nodiscard]] std::string source() const override { return m_texts.protocol + m_texts.truth; }

private:
    StudyTexts m_texts;
};

} // namespace

core::Expected<std::unique_ptr<SweepSubject>> makeStudySubject(const SweepPlan& plan,
                                                               const SubjectSources& sources) {
    StudyTexts texts;
    texts.protocolFile = pathBeside(plan, plan.subject);
    if (core::requireFile(texts.protocolFile)) {
        TELETA_TRY(texts.protocol, core::readFile(texts.protocolFile));
    } else {
        texts.protocolFile = plan.subject;
        TELETA_TRY(const study::Protocol builtIn, study::readNamedProtocol(plan.subject));
        texts.protocol = study::protocolText(builtIn);
    }
    texts.truthFile = pathBeside(plan, plan.truth);
    TELETA_TRY(texts.truth, core::readFile(texts.truthFile));
    texts.test = plan.test;
    texts.participants = plan.participants;
    TELETA_CHECK(studyOf(texts, {}));
    TELETA_CHECK(checkCells(plan, sources.checked, [&](std::uint64_t cell) -> core::Expected<void> {
        return studyOf(texts, plan.settingsOf(cell)).map([](const DrawnStudy&) {});
    }));
    return std::make_unique<StudySubject>(std::move(texts));
}

} // namespace teleta::sweep
