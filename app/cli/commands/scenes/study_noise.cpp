// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/scenes/study_noise.h"

#include "app/cli/base/command_io.h"
#include "app/cli/base/options.h"
#include "backend/core/failure.h"
#include "backend/study/session/pink_noise.h"

#include <QCoreApplication>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <vector>

namespace teleta::cli {

namespace {

struct NoiseText {
    Q_DECLARE_TR_FUNCTIONS(StudyCommand)
};

} // namespace

void StudyNoise::declare(CLI::App& app) {
    addOption(app, "-o,--out", m_out, NoiseText::tr("The sound file"), "FILE.wav")->required();
    addOption(app, "--level", m_level_dBFS,
              NoiseText::tr("Root mean square against full scale, dB; how loud it is at the ear has to be "
                            "measured"),
              between(-90, 0), "DBFS");
    addOption(app, "-s,--seed", m_seed, NoiseText::tr("Seed of the noise"), seed(), "S");
    declareJson(app, m_json);
}

core::Expected<void> StudyNoise::write() const {
    study::PinkNoiseSettings settings;
    settings.level_dBFS = m_level_dBFS;
    settings.seed = m_seed;
    TELETA_TRY(const std::vector<float> samples, study::pinkNoise(settings));
    TELETA_CHECK(study::writeMonoWav(samples, settings.rate_Hz, m_out));
    const double duration_s = static_cast<double>(settings.samples) / settings.rate_Hz;
    if (m_json)
        return printDocument({{"file", m_out},
                              {"duration_s", duration_s},
                              {"rate_hz", settings.rate_Hz},
                              {"level_dbfs", settings.level_dBFS}});
    return printFields(
        {{NoiseText::tr("File"), QString::fromStdString(m_out)},
         {NoiseText::tr("Period"), NoiseText::tr("%1 s").arg(forPeople(duration_s))},
         {NoiseText::tr("Level"), NoiseText::tr("%1 dBFS").arg(forPeople(settings.level_dBFS))}});
}

} // namespace teleta::cli
