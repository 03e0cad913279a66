// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/command_io.h"
#include "app/cli/base/frame_options.h"
#include "app/cli/base/interruption.h"
#include "app/cli/base/options.h"
#include "app/cli/base/progress_bar.h"
#include "app/cli/commands/camera/camera_commands.h"
#include "backend/core/beside_file.h"
#include "backend/core/failure.h"
#include "backend/vision/gel/gel_contacts.h"
#include "backend/vision/gel/marker_gel.h"
#include "backend/vision/gel/marker_gel_file.h"
#include "backend/vision/gel/marker_rows.h"
#include "devices/camera/video_stream.h"

#include <QCoreApplication>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace teleta::cli {

namespace {

struct MarkersText {
    Q_DECLARE_TR_FUNCTIONS(MarkersText)
};

constexpr double kMmPerM = 1000.0;

/// One contact over all its frames.
struct ContactSummary {
    double begin_s = 0.0, end_s = 0.0;
    vision::GelContactState largest; ///< where its markers moved furthest
    double moved_m = 0.0;
    std::optional<double> slipIndex; ///< the largest
    std::optional<double> incipientSlip_s, slip_s;
};

/// What one video shows, in the end.
struct MarkerSummary {
    long long frames = 0;
    long long unusable = 0; ///< frames that could not be decoded
    long long lost = 0;     ///< markers, over all frames
    double largest_m = 0.0;
    std::vector<ContactSummary> contacts;
    std::optional<double> firstJump_s, firstTorn_s, firstDead_s;
};

class MarkersCommand {
public:
    void declare(CLI::App& app) {
        addOption(app, "video", m_video,
                  MarkersText::tr("Video, pattern of numbered images (frame_%04d.png) or number of a camera; "
                                  "nothing touches the gel in the first frames. Default: the source that the "
                                  "sensor file names"),
                  "VIDEO");
        addOption(app, "--sensor", m_sensorPath, MarkersText::tr("Sensor file of kind \"marker_gel\""),
                  "FILE.toml")
            ->required();
        addFlag(app, "--summary", m_summaryOnly, MarkersText::tr("Print a summary instead of the table"));
        declareJson(app, m_output.json);
        declareOut(app, m_output.outPath);
    }

    [[nodiscard]] core::Expected<void> run() {
        if (m_summaryOnly && !m_output.outPath.empty())
            refuse("--summary", MarkersText::tr("a summary is printed; --out writes the table"));
        TELETA_TRY(const vision::MarkerGelFile file, vision::readMarkerGel(m_sensorPath));
        if (m_video.empty() && file.source.empty())
            refuse("VIDEO",
                   MarkersText::tr("neither a video is given nor does the sensor file name a source"));
        if (m_video.empty())
            m_video = camera::isCameraNumber(file.source) ? file.source
                                                          : core::besideFile(m_sensorPath, file.source);
        refuseToReplace(m_output.outPath, std::array{m_video, m_sensorPath});
        TELETA_TRY(
            camera::VideoStream stream,
            camera::VideoStream::open(m_video, {.width_px = file.width_px,
                                                .height_px = file.height_px,
                                                .rate_Hz = file.rate_Hz,
                                                .channel = static_cast<camera::VideoChannel>(file.channel)}));
        std::vector<cv::Mat1b> first;
        std::vector<Frame> waiting;
        TELETA_CHECK(readFirst(stream, file, first, waiting));
        auto made = vision::MarkerGel::make(file, first);
        if (!made)
            return inVideo(made.error());
        vision::MarkerGel& gel = *made;
        std::optional<RowOutput> rows;
        if (!m_summaryOnly) {
            TELETA_TRY(rows, RowOutput::open(vision::kMarkerColumns, m_output));
        }
        ProgressBar progress(ProgressBar::Unit::simulatedSeconds, rows && rows->onTerminal());
        const double duration_s =
            stream.rate_Hz() > 0.0 ? static_cast<double>(stream.framesTotal()) / stream.rate_Hz() : 0.0;
        bool stopped = false;
        for (std::size_t next = 0; !(stopped = interrupted()) && !(rows && rows->failed()); ++next) {
            Frame frame;
            if (next < waiting.size()) {
                frame = waiting[next];
            } else {
                TELETA_TRY(const bool isThere, read(stream, file, frame));
                if (!isThere) {
                    stopped = interrupted();
                    break;
                }
            }
            if (auto tracked = gel.track(frame.picture, frame.time_s); !tracked)
                return inVideo(tracked.error());
            add(gel, frame.time_s);
            if (m_summaryOnly)
                addContacts(gel, frame.time_s);
            if (rows) {
                vision::writeMarkers(*rows, frame.number, frame.time_s, gel.markers(), gel.motions());
                rows->flushIfDue();
            }
            progress.update(frame.time_s, duration_s);
        }
        progress.erase();
        if (rows) {
            TELETA_CHECK(rows->finish());
        }
        tellFaults(stream);
        if (m_summaryOnly) {
            TELETA_CHECK(print(gel));
        }
        if (stopped)
            return core::Unexpected(interruption());
        if (m_gone)
            return gone();
        return {};
    }

private:
    struct Frame {
        cv::Mat1b picture;
        double time_s = 0.0;
        long long number = 0;
    };

    [[nodiscard]] core::Unexpected inVideo(core::Error error) const {
        error.where.file = m_video;
        if (error.kind == core::ErrorKind::refused)
            error.kind = core::ErrorKind::badInput;
        return core::Unexpected(error);
    }

    [[nodiscard]] core::Unexpected gone() const {
        return core::failed(core::ErrorKind::unavailable,
                            MarkersText::tr("the camera has stopped sending frames"), {}, {m_video});
    }

    /// The next frame that can be decoded; false: there are no more.
    [[nodiscard]] core::Expected<bool> read(camera::VideoStream& stream, const vision::MarkerGelFile& file,
                                            Frame& frame) {
        using Outcome = camera::VideoStream::Outcome;
        cv::Mat1b image;
        while (!interrupted()) {
            const Outcome outcome = stream.next(image, frame.time_s);
            if (outcome == Outcome::ended || outcome == Outcome::gone) {
                m_gone = outcome == Outcome::gone;
                return false;
            }
            if (outcome == Outcome::late)
                continue;
            frame.number = m_next++;
            if (outcome == Outcome::undecodable) {
                ++m_summary.unusable;
                continue;
            }
            auto picture = vision::MarkerGel::picture(file, image);
            if (!picture)
                return inVideo(picture.error());
            // The stream may use the memory of its image again.
            frame.picture = picture->clone();
            return true;
        }
        return false;
    }

    /// The frames from which the places at rest are found.
    [[nodiscard]] core::Expected<void> readFirst(camera::VideoStream& stream,
                                                 const vision::MarkerGelFile& file,
                                                 std::vector<cv::Mat1b>& first, std::vector<Frame>& waiting) {
        while (waiting.size() < vision::MarkerGel::kReferencePictures) {
            Frame frame;
            TELETA_TRY(const bool isThere, read(stream, file, frame));
            if (!isThere)
                break;
            first.push_back(frame.picture);
            waiting.push_back(frame);
        }
        if (interrupted())
            return core::Unexpected(interruption());
        if (waiting.size() >= 2)
            return {};
        if (m_gone)
            return gone();
        return core::failed(core::ErrorKind::badInput,
                            waiting.empty()
                                ? MarkersText::tr("the video has no frame that can be decoded")
                                : MarkersText::tr("the video has only one frame, so nothing moves in it"),
                            MarkersText::tr("at least two frames"), {m_video});
    }

    void add(const vision::MarkerGel& gel, double time_s) {
        ++m_summary.frames;
        m_summary.lost += static_cast<long long>(gel.markers().size() - gel.found());
        for (const vision::GelMotion& motion : gel.motions()) {
            if (motion.found)
                m_summary.largest_m = std::max(m_summary.largest_m, motion.displacement_m.norm());
        }
        const auto keepFirst = [time_s](bool is, std::optional<double>& first_s) {
            if (is && !first_s)
                first_s = time_s;
        };
        keepFirst(gel.faults().dead, m_summary.firstDead_s);
        keepFirst(gel.faults().lightJumped, m_summary.firstJump_s);
        keepFirst(gel.faults().torn, m_summary.firstTorn_s);
    }

    void addContacts(const vision::MarkerGel& gel, double time_s) {
        for (const vision::GelContactState& contact : m_contacts.next(gel)) {
            const auto number = static_cast<std::size_t>(contact.id);
            if (number > m_summary.contacts.size()) {
                m_summary.contacts.resize(number);
                m_summary.contacts.back().begin_s = time_s;
            }
            ContactSummary& all = m_summary.contacts[number - 1];
            all.end_s = time_s;
            double moved_m = 0.0;
            for (const std::size_t i : contact.markers)
                if (gel.motions()[i].found)
                    moved_m = std::max(moved_m, gel.motions()[i].displacement_m.norm());
            if (moved_m > all.moved_m) {
                all.moved_m = moved_m;
                all.largest = contact;
            }
            if (contact.slipIndex)
                all.slipIndex = std::max(all.slipIndex.value_or(0.0), *contact.slipIndex);
            if (contact.event == vision::SlipEvent::incipientSlip && !all.incipientSlip_s)
                all.incipientSlip_s = time_s;
            if (contact.event == vision::SlipEvent::slip && !all.slip_s)
                all.slip_s = time_s;
        }
    }

    void tellFaults(const camera::VideoStream& stream) const {
        const auto tell = [](const std::optional<double>& at_s, const QString& text) {
            if (at_s)
                warn(text.arg(forPeople(*at_s)));
        };
        tell(m_summary.firstDead_s,
             MarkersText::tr("The picture has no contrast at %1 s: is the camera covered?"));
        tell(m_summary.firstJump_s, MarkersText::tr("The light jumps at %1 s"));
        tell(m_summary.firstTorn_s,
             MarkersText::tr(
                 "At %1 s more than 30 % of the markers have been lost for 1 s: is the gel torn?"));
        if (m_summary.unusable > 0)
            warn(MarkersText::tr("Frames that cannot be decoded: %1").arg(m_summary.unusable));
        if (stream.framesSkipped() > 0)
            warn(MarkersText::tr("Frames missing according to their time stamps: %1")
                     .arg(stream.framesSkipped()));
    }

    [[nodiscard]] core::Expected<void> print(const vision::MarkerGel& gel) const {
        const auto all = static_cast<double>(m_summary.frames) * static_cast<double>(gel.markers().size());
        const double found = all > 0.0 ? 1.0 - static_cast<double>(m_summary.lost) / all : 0.0;
        if (m_output.json) {
            nlohmann::ordered_json document;
            document["frames"] = m_summary.frames;
            document["markers"] = gel.markers().size();
            document["found_share"] = found;
            document["diameter_px"] = gel.diameter_px();
            document["pitch_px"] = gel.pitch_px();
            document["reference_frames"] = gel.referencePictures();
            document["noise_px"] = gel.noise_px();
            document["largest_displacement_m"] = m_summary.largest_m;
            document["dead_at_s"] = orNull(m_summary.firstDead_s);
            document["light_jump_at_s"] = orNull(m_summary.firstJump_s);
            document["torn_at_s"] = orNull(m_summary.firstTorn_s);
            document["contacts"] = nlohmann::ordered_json::array();
            for (const ContactSummary& contact : m_summary.contacts) {
                nlohmann::ordered_json entry;
                entry["begin_s"] = contact.begin_s;
                entry["end_s"] = contact.end_s;
                entry["centre_x_m"] = contact.largest.centre_m.x();
                entry["centre_y_m"] = contact.largest.centre_m.y();
                entry["area_m2"] = contact.largest.area_m2;
                entry["normal_proxy_m2"] = contact.largest.normalProxy_m2;
                entry["shear_proxy_x_m"] = contact.largest.shearProxy_m.x();
                entry["shear_proxy_y_m"] = contact.largest.shearProxy_m.y();
                entry["torsion_rad"] = contact.largest.torsion_rad;
                entry["slip_index"] = orNull(contact.slipIndex);
                entry["incipient_slip_at_s"] = orNull(contact.incipientSlip_s);
                entry["slip_at_s"] = orNull(contact.slip_s);
                document["contacts"].push_back(std::move(entry));
            }
            return printDocument(document);
        }
        Fields fields{
            {MarkersText::tr("frames"), QString::number(m_summary.frames)},
            {MarkersText::tr("markers"), QString::number(gel.markers().size())},
            {MarkersText::tr("found"), MarkersText::tr("%1 %").arg(forPeople(100.0 * found))},
            {MarkersText::tr("diameter"), MarkersText::tr("%1 px").arg(forPeople(gel.diameter_px()))},
            {MarkersText::tr("distance of neighbours"),
             MarkersText::tr("%1 px").arg(forPeople(gel.pitch_px()))},
            {MarkersText::tr("frames for the places at rest"), QString::number(gel.referencePictures())},
            {MarkersText::tr("noise of a place"), MarkersText::tr("%1 px").arg(forPeople(gel.noise_px()))},
            {MarkersText::tr("largest displacement"),
             MarkersText::tr("%1 mm").arg(forPeople(kMmPerM * m_summary.largest_m))},
            {MarkersText::tr("contacts"), QString::number(m_summary.contacts.size())},
        };
        for (std::size_t i = 0; i < m_summary.contacts.size(); ++i)
            fields.emplace_back(MarkersText::tr("contact %1").arg(i + 1), textOf(m_summary.contacts[i]));
        return printFields(fields);
    }

    [[nodiscard]] static QString textOf(const ContactSummary& contact) {
        QString text = MarkersText::tr("%1 s to %2 s, centre (%3, %4) mm")
                           .arg(forPeople(contact.begin_s), forPeople(contact.end_s),
                                forPeople(kMmPerM * contact.largest.centre_m.x()),
                                forPeople(kMmPerM * contact.largest.centre_m.y()));
        if (contact.slipIndex)
            text += MarkersText::tr(", slip index up to %1").arg(forPeople(*contact.slipIndex));
        if (contact.slip_s)
            text += MarkersText::tr(", slip at %1 s").arg(forPeople(*contact.slip_s));
        return text;
    }

    std::string m_video;
    std::string m_sensorPath;
    bool m_summaryOnly = false;
    RowOptions m_output;
    MarkerSummary m_summary;
    vision::GelContacts m_contacts;
    long long m_next = 0;
    bool m_gone = false;
};

} // namespace

Command markersCommand() {
    return makeCommand<MarkersCommand>("markers",
                                       MarkersText::tr("Follow the markers of a flat gel in a video"),
                                       "teleta markers press.avi --sensor gel.toml --out markers.csv");
}

} // namespace teleta::cli
