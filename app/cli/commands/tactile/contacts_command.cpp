// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/tactile/contacts_command.h"

#include "backend/contact/contact_tracker.h"

#include <QCoreApplication>

#include <array>

namespace teleta::cli {

QString ContactsCommand::summary() const {
    return QCoreApplication::translate("ContactsCommand",
                                       "Place, force and identity of each contact of each tactile frame");
}

const char* ContactsCommand::example() const {
    return "teleta simulate tactile-indenter --out run\n"
           "  teleta contacts run/frames.csv --threshold 0.3 --json";
}

core::Expected<void> ContactsCommand::run() {
    constexpr std::array<std::string_view, 7> kColumns{"time_s",  "contact_id", "x_m",    "y_m",
                                                       "force_n", "peak_n",     "area_m2"};
    contact::SegmentationSettings settings = m_options.segmentationSettings();
    contact::ContactSegmenter segmenter(m_options.layout(), settings);
    contact::FeatureExtractor extractor(m_options.layout(), m_options.featureSettings());
    contact::ContactTracker tracker(contact::trackingFor(m_options.layout()));
    return processFrames(m_options, kColumns, [&](const ConditionedFrame& frame, RowOutput& rows) {
        if (m_options.automaticThreshold) {
            settings.threshold_N = extractor.compute(frame.load_N, frame.dead).threshold_N;
            segmenter.setSettings(settings);
        }
        const std::span<contact::Contact> contacts = segmenter.segment(frame.load_N, frame.dead);
        tracker.assign(contacts, frame.time_s);
        for (const contact::Contact& contact : contacts) {
            rows.number(frame.time_s);
            rows.integer(contact.id);
            rows.number(contact.x_m);
            rows.number(contact.y_m);
            rows.number(contact.force_N);
            rows.number(contact.peak_N);
            rows.number(contact.area_m2);
            rows.endRow();
        }
    });
}

} // namespace teleta::cli
