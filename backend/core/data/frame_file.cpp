// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/frame_file.h"

#include "backend/core/failure.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

namespace teleta::core {

namespace {

struct FrameFileText {
    Q_DECLARE_TR_FUNCTIONS(FrameFileText)
};

constexpr int kVector = 3;

/// The name of the taxel column of this index: "t0", "t1", ..., of vectors "t0_x", "t0_y", "t0_z", "t1_x".
std::string taxelName(std::size_t index, int components) {
    if (components != kVector)
        return 't' + std::to_string(index);
    static constexpr std::array<const char*, kVector> kAxes{"_x", "_y", "_z"};
    return 't' + std::to_string(index / kVector) + kAxes[index % kVector];
}

/// Number of taxel columns when the header is time_s,t0,t1,... with or without a last utc_s, which is not
/// read.
Expected<std::size_t> checkHeader(const CsvReader& csv, int components = 1) {
    const std::vector<std::string>& header = csv.header();
    TELETA_CHECK(csv.column("time_s"));
    const std::size_t read = header.size() - (header.size() > 1 && header.back() == "utc_s" ? 1 : 0);
    for (std::size_t i = 0; i < read; ++i) {
        const std::string expected = i == 0 ? "time_s" : taxelName(i - 1, components);
        if (header[i] == expected)
            continue;
        if (i == 1 && components != kVector && header[i] == taxelName(0, kVector))
            return failed(ErrorKind::badInput, FrameFileText::tr("the frames are of vectors, t0_x,t0_y,t0_z"),
                          FrameFileText::tr("one number a taxel; or the file that says where the taxels are "
                                            "(--layout FILE.toml)"),
                          csv.place(i));
        return failed(ErrorKind::badInput,
                      FrameFileText::tr("column %1 is \"%2\"")
                          .arg(i + 1)
                          .arg(QString::fromStdString(header[i]).left(40)),
                      QString::fromStdString(expected), csv.place(i));
    }
    if (read == 1)
        return failed(ErrorKind::badInput, FrameFileText::tr("there are no taxel columns"),
                      FrameFileText::tr("the columns time_s, t0, t1, ..."), csv.place(1));
    return read - 1;
}

QString shortest(double value) {
    char text[32];
    const auto [end, code] = std::to_chars(text, text + sizeof text, value);
    return QString::fromLatin1(text, end - text);
}

} // namespace

FrameFile::FrameFile(CsvReader csv, const ArrayLayout& layout)
    : m_csv(std::move(csv))
    , m_layout(layout) {
}

Expected<FrameFile> FrameFile::open(const std::string& path, const ArrayLayout& layout, int components) {
    TELETA_TRY(CsvReader csv, CsvReader::open(path));
    const Expected<std::size_t> taxels = checkHeader(csv, components);
    TELETA_CHECK(taxels);
    if (*taxels != layout.taxels())
        return failed(ErrorKind::badInput, FrameFileText::tr("the file has %1 taxel columns").arg(*taxels),
                      FrameFileText::tr("%1 = %2 rows x %3 columns")
                          .arg(layout.taxels())
                          .arg(layout.rows)
                          .arg(layout.columns),
                      csv.place(std::min(*taxels, layout.taxels()) + 1));
    return FrameFile(std::move(csv), layout);
}

Expected<std::size_t> FrameFile::countTaxels(const std::string& path) {
    TELETA_TRY(const CsvReader csv, CsvReader::open(path));
    return checkHeader(csv);
}

Expected<bool> FrameFile::next(double& time_s, std::span<float> values) {
    const Expected<bool> any = m_csv.next(m_row, true);
    if (!any)
        return any;
    if (!*any) {
        if (!m_anyFrame)
            return failed(ErrorKind::badInput, FrameFileText::tr("the recording has no frames"),
                          FrameFileText::tr("at least one row after the header"),
                          {m_csv.path(), m_csv.nextLine(), 1});
        return false;
    }
    const double time = m_row.front();
    if (!std::isfinite(time))
        return failed(ErrorKind::badInput, FrameFileText::tr("the time is %1").arg(shortest(time)),
                      FrameFileText::tr("a finite time in s"), m_csv.place(0));
    if (m_lastTime_s && time < *m_lastTime_s)
        return failed(ErrorKind::badInput,
                      FrameFileText::tr("the time goes back from %1 to %2")
                          .arg(shortest(*m_lastTime_s), shortest(time)),
                      FrameFileText::tr("times that do not decrease"), m_csv.place(0));
    m_anyFrame = true;
    m_lastTime_s = time;
    time_s = time;
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<float>(m_row[i + 1]);
    return true;
}

Expected<void> FrameFile::seek(std::uint64_t offset, long long line) {
    const Expected<void> done = m_csv.seek(offset, line);
    if (done) {
        m_lastTime_s.reset();
        m_anyFrame = true;
    }
    return done;
}

Expected<std::vector<float>> readFrames(const std::string& path, const ArrayLayout& layout,
                                        const std::function<bool()>& goOn) {
    TELETA_TRY(FrameFile file, FrameFile::open(path, layout));
    std::vector<float> frame(layout.taxels());
    std::vector<float> frames;
    double time_s = 0.0;
    for (;;) {
        TELETA_TRY(const bool any, file.next(time_s, frame));
        if (!any)
            return frames;
        if (goOn && !goOn())
            return Unexpected(Error{ErrorKind::cancelled, {}, {}, {}});
        frames.insert(frames.end(), frame.begin(), frame.end());
    }
}

Expected<std::vector<float>> readTare(const std::string& path, const ArrayLayout& layout) {
    TELETA_TRY(FrameFile file, FrameFile::open(path, layout));
    const std::size_t taxels = layout.taxels();
    std::vector<float> values(taxels);
    std::vector<double> sum(taxels, 0.0);
    std::vector<std::size_t> count(taxels, 0);
    double time_s = 0.0;
    for (;;) {
        TELETA_TRY(const bool any, file.next(time_s, values));
        if (!any)
            break;
        for (std::size_t i = 0; i < taxels; ++i) {
            if (std::isfinite(values[i])) {
                sum[i] += static_cast<double>(values[i]);
                ++count[i];
            }
        }
    }
    for (std::size_t i = 0; i < taxels; ++i)
        values[i] = count[i] > 0 ? static_cast<float>(sum[i] / static_cast<double>(count[i]))
                                 : std::numeric_limits<float>::quiet_NaN();
    return values;
}

} // namespace teleta::core
