// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/frames/text_lines.h"

#include "backend/core/data/file_kind.h"
#include "backend/core/failure.h"

#include <QCoreApplication>

#include <algorithm>
#include <charconv>
#include <limits>
#include <utility>

namespace teleta::frames {

namespace {

struct TextLinesText {
    Q_DECLARE_TR_FUNCTIONS(TextLinesText)
};

constexpr std::size_t kMostLine = std::size_t{16} << 20;
constexpr std::size_t kShortLine = 4096; ///< for which there is room at once

std::string_view trimmed(std::string_view text) {
    const auto isOuter = [](char c) { return c == ' ' || c == '\t'; };
    while (!text.empty() && isOuter(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && isOuter(text.back()))
        text.remove_suffix(1);
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"')
        text = text.substr(1, text.size() - 2);
    return text;
}

} // namespace

TextLines::TextLines(std::string path)
    : m_path(std::move(path))
    , m_file(QString::fromStdString(m_path)) {
}

core::Expected<void> TextLines::open() {
    if (!m_file.open(QIODevice::ReadOnly))
        return core::failed(core::ErrorKind::ioFailed, m_file.errorString(), {}, {m_path});
    return {};
}

/// The next line with its end, or as much of it as shows that it is too long; empty at the end or at an
/// error. QFile::readLine would take room for the longest line each time.
std::string_view TextLines::readLine() {
    std::size_t size = 0;
    for (;;) {
        if (size + 1 >= m_buffer.size())
            m_buffer.resize(std::max(kShortLine, 2 * m_buffer.size()));
        const qint64 got =
            m_file.readLine(m_buffer.data() + size, static_cast<qint64>(m_buffer.size() - size));
        if (got <= 0)
            break;
        size += static_cast<std::size_t>(got);
        if (m_buffer[size - 1] == '\n' || size > kMostLine)
            break;
    }
    return {m_buffer.data(), size};
}

core::Expected<std::optional<std::string_view>> TextLines::next() {
    const std::string_view whole = readLine();
    if (whole.empty()) {
        if (m_file.error() != QFileDevice::NoError)
            return core::failed(core::ErrorKind::ioFailed, m_file.errorString(), {}, {m_path});
        return std::optional<std::string_view>();
    }
    ++m_number;
    std::string_view line = whole;
    if (whole.size() > kMostLine)
        return wrong(TextLinesText::tr("the line is longer than 16 MiB"), TextLinesText::tr("a line end"));
    if (m_number == 1 && line.starts_with("\xEF\xBB\xBF"))
        line.remove_prefix(3);
    while (!line.empty() && (line.back() == '\n' || line.back() == '\r'))
        line.remove_suffix(1);
    if (std::ranges::find(line, '\0') != line.end())
        return wrong(TextLinesText::tr("the line has a byte 0, which no text has"),
                     TextLinesText::tr("text"));
    return std::optional(line);
}

core::Unexpected TextLines::wrong(const QString& message, const QString& expected, long long column) const {
    return core::failed(core::ErrorKind::badInput, message, expected, {m_path, m_number, column});
}

void splitFields(std::string_view line, char separator, std::vector<std::string_view>& fields) {
    fields.clear();
    std::size_t begin = 0;
    bool isQuoted = false;
    for (std::size_t i = 0; i <= line.size(); ++i) {
        if (i < line.size() && line[i] == '"')
            isQuoted = !isQuoted;
        const bool isEnd = i == line.size() ||
                           (!isQuoted && (line[i] == separator || (separator == ' ' && line[i] == '\t')));
        if (!isEnd)
            continue;
        const std::string_view field = line.substr(begin, i - begin);
        begin = i + 1;
        if (separator != ' ' || !field.empty())
            fields.push_back(trimmed(field));
    }
}

std::optional<double> fieldNumber(std::string_view field, bool hasDecimalComma) {
    if (field == "NA")
        return std::numeric_limits<double>::quiet_NaN();
    if (field.starts_with('+') && !field.starts_with("+-"))
        field.remove_prefix(1);
    char copy[64];
    if (hasDecimalComma && field.find(',') != std::string_view::npos) {
        if (field.size() > sizeof copy || field.find('.') != std::string_view::npos)
            return std::nullopt;
        std::ranges::replace_copy(field, copy, ',', '.');
        field = {copy, field.size()};
    }
    double value = 0.0;
    const char* end = field.data() + field.size();
    const auto [stop, code] = std::from_chars(field.data(), end, value);
    if (stop != end || code != std::errc())
        return std::nullopt;
    return value;
}

QString shownField(std::string_view field) {
    QString text =
        QString::fromUtf8(field.data(), static_cast<qsizetype>(std::min<std::size_t>(field.size(), 160)));
    for (QChar& c : text)
        if (!c.isPrint() && !c.isSurrogate())
            c = QChar(QChar::ReplacementCharacter);
    if (text.size() > 40)
        text = text.left(40) + QStringLiteral("…");
    return QStringLiteral("\"%1\"").arg(text);
}

} // namespace teleta::frames
