// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/feature_rows.h"
#include "app/cli/base/frame_options.h"
#include "app/cli/base/options.h"
#include "app/cli/commands/tactile/tactile_commands.h"
#include "backend/contact/contact_tracker.h"

#include <QCoreApplication>

#include <utility>

namespace teleta::cli {

namespace {

struct ContactsCommand : FrameOptions {
    [[nodiscard]] core::Expected<void> run() {
        TELETA_TRY(OpenFrames frames, openFrames(*this));
        contact::SegmentationSettings settings = segmentationSettings();
        const core::TaxelLayout taxels = frames.reader.taxels();
        const bool vectors = taxels.isVector();
        const auto columns = withSummit(contactRowColumns(frames.loadUnit, vectors), summit);
        if (!frames.isGridOfLoads()) {
            if (automaticThreshold)
                refuse("--auto-threshold",
                       QCoreApplication::translate("ContactsCommand", "this is for loads on a grid"));
            return analyseFrames(*this, std::move(frames), columns,
                                 [&](double time_s, const contact::TaxelFrame& frame, RowOutput& rows) {
                                     for (const contact::Contact& contact : frame.contacts) {
                                         writeContact(rows, time_s, contact, vectors);
                                         rows.endRow();
                                     }
                                 });
        }
        const core::ArrayLayout layout = taxels.grid();
        contact::ContactSegmenter segmenter(layout, settings);
        contact::FeatureExtractor extractor(layout, featureSettings());
        contact::ContactTracker tracker(contact::trackingFor(layout));
        return processFrames(
            *this, std::move(frames), columns, [&](const ConditionedFrame& frame, RowOutput& rows) {
                if (automaticThreshold) {
                    settings.threshold_N = extractor.compute(frame.load_N, frame.dead).threshold_N;
                    segmenter.setSettings(settings);
                }
                const std::span<contact::Contact> contacts = segmenter.segment(frame.load_N, frame.dead);
                tracker.assign(contacts, frame.time_s);
                for (const contact::Contact& contact : contacts) {
                    writeContact(rows, frame.time_s, contact, false);
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
