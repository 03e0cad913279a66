// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/feature_rows.h"
#include "app/cli/base/frame_options.h"
#include "app/cli/commands/tactile/tactile_commands.h"
#include "backend/contact/contact_tracker.h"

#include <QCoreApplication>

#include <array>
#include <utility>

namespace teleta::cli {

namespace {

struct ContactsCommand : FrameOptions {
    [[nodiscard]] core::Expected<void> run() const {
        constexpr std::array<std::string_view, 7> kColumns{"time_s",  "contact_id", "x_m",    "y_m",
                                                           "force_n", "peak_n",     "area_m2"};
        contact::SegmentationSettings settings = segmentationSettings();
        TELETA_TRY(frames::FrameReader frames, openFrames(*this));
        const core::ArrayLayout layout = frames.layout();
        contact::ContactSegmenter segmenter(layout, settings);
        contact::FeatureExtractor extractor(layout, featureSettings());
        contact::ContactTracker tracker(contact::trackingFor(layout));
        return processFrames(
            *this, std::move(frames), withSummit(kColumns, summit),
            [&](const ConditionedFrame& frame, RowOutput& rows) {
                if (automaticThreshold) {
                    settings.threshold_N = extractor.compute(frame.load_N, frame.dead).threshold_N;
                    segmenter.setSettings(settings);
                }
                const std::span<contact::Contact> contacts = segmenter.segment(frame.load_N, frame.dead);
                tracker.assign(contacts, frame.time_s);
                for (const contact::Contact& contact : contacts) {
                    rows.number(frame.time_s);
                    rows.integer(contact.id);
                    for (const double value :
                         {contact.x_m, contact.y_m, contact.force_N, contact.peak_N, contact.area_m2})
                        rows.number(value);
                    if (summit)
                        writeSummit(rows, contact::summitOf(frame.load_N, layout, segmenter, contact,
                                                            frame.dead, noise_N));
                    rows.endRow();
                }
            });
    }
};

} // namespace

Command contactsCommand() {
    return makeCommand<ContactsCommand>(
        "contacts",
        QCoreApplication::translate("ContactsCommand",
                                    "Place, force and identity of each contact of each tactile frame"),
        "teleta simulate tactile-indenter --out run\n"
        "  teleta contacts run/frames.csv --threshold 0.3 --json");
}

} // namespace teleta::cli
