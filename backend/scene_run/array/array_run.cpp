// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/scene_run/array/array_run.h"

#include "backend/contact/contact_segmenter.h"
#include "backend/contact/frame_conditioner.h"
#include "backend/equilibration/taxel_gains.h"
#include "backend/scene_run/array/contact_errors.h"
#include "backend/scene_run/base/run_csv.h"
#include "backend/scene_run/base/scene_recording.h"
#include "backend/scene_run/base/scene_settings.h"
#include "backend/simulation/array/simulated_array.h"
#include "backend/simulation/effects/gain_spread.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace teleta::scene_run {

namespace {

constexpr std::uint64_t kFramesBetweenReports = 256;
constexpr std::uint64_t kMostGainFrames = 4000;

/// How wrong the gains are that are found from these frames, rms, relative; empty when none can be found.
std::optional<double> gainError(const scene::Scene& scene, const scene::GainSpreadSpec& spec,
                                std::uint64_t seed, const std::vector<float>& frames) {
    const core::ArrayLayout& layout = scene.array().sensor.layout;
    const auto gains =
        equilibration::findTaxelGains(layout, std::array{equilibration::GainPress{frames, {}}});
    if (!gains)
        return std::nullopt;
    const std::vector<double> factors =
        simulation::gainFactors(spec, layout.taxels(), core::RandomStream(seed, spec.kRow.name));
    // Nobody knows the load: the gains are right when all products are the same.
    double sum = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < factors.size(); ++i)
        sum += gains->taxels[i].isGood() ? gains->taxels[i].gain * factors[i] : 0.0;
    const auto good = static_cast<double>(gains->good());
    for (std::size_t i = 0; i < factors.size(); ++i) {
        if (gains->taxels[i].isGood())
            squares += std::pow(gains->taxels[i].gain * factors[i] * good / sum - 1.0, 2);
    }
    return std::sqrt(squares / good);
}

/// The contacts of the indenters that press, whatever the sensor feels of them.
class IndenterLabels {
public:
    explicit IndenterLabels(std::size_t indenters)
        : m_identities(indenters, 0) {}

    std::span<const ContactLabel> of(const std::vector<simulation::IndenterTruth>& indenters) {
        m_contacts.clear();
        for (std::size_t i = 0; i < indenters.size(); ++i) {
            const simulation::IndenterLoad& load = indenters[i].load;
            if (!load.copX_m || !load.copY_m) {
                m_identities[i] = 0;
                continue;
            }
            if (m_identities[i] == 0)
                m_identities[i] = ++m_last;
            // The foundation has no friction: it carries what is along its own normal.
            m_contacts.push_back({.object = static_cast<std::int32_t>(i),
                                  .identity = m_identities[i],
                                  .x_m = *load.copX_m,
                                  .y_m = *load.copY_m,
                                  .force_N = load.force_N});
        }
        return m_contacts;
    }

private:
    std::vector<std::int32_t> m_identities; ///< of each indenter; 0: it does not press
    std::vector<ContactLabel> m_contacts;
    std::int32_t m_last = 0;
};

} // namespace

core::Expected<SceneSummary> runArrayScene(const scene::Scene& scene, const RunOptions& options) {
    TELETA_TRY(auto array, simulation::SimulatedArray::make(scene, options.seed));
    const core::SourceDescription description = array->description();
    const core::ArrayLayout& layout = description.layout.grid();
    TELETA_TRY(RunCsv log, RunCsv::openFrames(options.outFolder, layout.taxels()));
    TELETA_TRY(SceneRecording recording, SceneRecording::open(options, scene));
    recording.beginArray(description, scene);

    const double duration_s = options.duration_s.value_or(scene.duration_s);
    const auto frames = static_cast<std::uint64_t>(std::llround(duration_s * description.nominalRate_Hz));
    const contact::FrameConditioner conditioner(layout.taxels(), {});
    const contact::SegmentationSettings settings = channelSettings(scene).segmentation;
    contact::ContactSegmenter segmenter(layout, settings);
    std::vector<float> values(layout.taxels());
    std::vector<float> load_N(layout.taxels());
    std::vector<std::uint8_t> dead(layout.taxels());

    SceneSummary summary;
    ContactErrors errors;
    std::optional<double> firstContact_s;
    std::vector<bool> pressing(scene.array().indenters.size(), false);
    const auto* spread = scene.listed<scene::GainSpreadSpec>();
    std::vector<float> press;
    IndenterLabels labels(scene.array().indenters.size());
    std::uint64_t frame = 0;
    for (; frame < frames && !log.failed(); ++frame) {
        summary.interrupted = options.endsAt(frame, kFramesBetweenReports, array->time_s(), duration_s);
        if (summary.interrupted)
            break;
        array->next(values, false);
        log.row(array->time_s(), values);
        recording.addFrame(array->time_s(), values);
        if (options.onFrame)
            options.onFrame({array->time_s(), values, labels.of(array->truth().indenters)});
        if (spread != nullptr && frame < kMostGainFrames)
            press.insert(press.end(), values.begin(), values.end());
        conditioner.apply(values, load_N, dead);
        const auto found = segmenter.segment(load_N, dead);
        if (!found.empty() && !firstContact_s)
            firstContact_s = array->time_s();

        const auto& truths = array->truth().indenters;
        for (std::size_t i = 0; i < truths.size(); ++i) {
            const simulation::IndenterTruth& truth = truths[i];
            const bool presses = truth.load.force_N >= settings.threshold_N && truth.load.copX_m;
            if (presses)
                errors.add(*truth.load.copX_m, *truth.load.copY_m, found);
            if (presses != pressing[i])
                summary.events.push_back({{"time_s", array->time_s()},
                                          {"event", presses ? "contact_begins" : "contact_ends"},
                                          {"object", truth.name}});
            pressing[i] = presses;
        }
    }
    for (const core::Expected<void>& written : {log.finish(), recording.finish()})
        TELETA_CHECK(written);

    summary.takeTimes(*array);
    errors.report(summary.measures);
    if (spread != nullptr)
        summary.measures["taxel_gain_error_rms"] = orNull(gainError(scene, *spread, options.seed, press));
    summary.measures["first_contact_s"] = orNull(firstContact_s);
    summary.measures["frames"] = frame;
    summary.measures["frames_lost"] = 0;
    return summary;
}

} // namespace teleta::scene_run
