// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/csv_reader.h"

#include "backend/core/failure.h"

#include <QCoreApplication>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <fcntl.h>
#include <limits>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace teleta::core {

namespace {

constexpr std::size_t kMaximumLine = 16U << 20U;
constexpr std::size_t kFirstBuffer = 256U << 10U;
constexpr std::size_t kShownNames = 8;
constexpr qsizetype kShownCharacters = 40;

struct CsvReaderText {
    Q_DECLARE_TR_FUNCTIONS(CsvReaderText)
};

bool isBlank(char c) {
    return c == ' ' || c == '\t';
}

/// What the file has, fit for one line of a terminal: cut after some characters, nothing that is not
/// printable.
QString shown(std::string_view text) {
    QString result =
        QString::fromUtf8(text.data(), static_cast<qsizetype>(std::min<std::size_t>(text.size(), 400)));
    for (QChar& c : result) {
        if (!c.isPrint() && !c.isSurrogate())
            c = QChar(QChar::ReplacementCharacter);
    }
    if (result.size() > kShownCharacters)
        result = result.left(kShownCharacters) + QStringLiteral("…");
    return QStringLiteral("\"%1\"").arg(result);
}

template <typename Names>
QString shownNames(const Names& names) {
    QStringList list;
    for (const auto& name : names) {
        if (list.size() == static_cast<qsizetype>(kShownNames)) {
            list += QStringLiteral("…");
            break;
        }
        const QString text = shown(name);
        list += text.mid(1, text.size() - 2);
    }
    return list.join(QStringLiteral(", "));
}

/// One field of a row: its text without quotes and outer blanks, and where it ends (at the comma or the row's
/// end).
struct Field {
    std::string text;
    const char* end = nullptr;
    bool wellFormed = true; ///< false: something stands before or behind the quotes
};

Field readField(const char* begin, const char* rowEnd) {
    Field field;
    const char* p = std::find_if_not(begin, rowEnd, isBlank);
    if (p == rowEnd || *p != '"') {
        field.end = std::find(p, rowEnd, ',');
        const char* last = field.end;
        while (last > p && isBlank(last[-1]))
            --last;
        field.text.assign(p, last);
        return field;
    }
    for (++p; p < rowEnd; ++p) {
        if (*p == '"') {
            if (p + 1 == rowEnd || p[1] != '"')
                break;
            ++p;
        }
        field.text += *p;
    }
    p = std::find_if_not(std::min(p + 1, rowEnd), rowEnd, isBlank);
    field.end = std::find(p, rowEnd, ',');
    field.wellFormed = field.end == p;
    return field;
}

bool matches(std::errc code) {
    return code == std::errc{};
}

/// Number of a whole text in the C locale; blanks around it and a leading plus are allowed.
bool parseNumber(const char* begin, const char* end, double& value) {
    begin = std::find_if_not(begin, end, isBlank);
    while (end > begin && isBlank(end[-1]))
        --end;
    if (end - begin > 1 && *begin == '+' && begin[1] != '-')
        ++begin;
    const auto [stop, code] = std::from_chars(begin, end, value);
    if (stop != end)
        return false;
    if (code == std::errc::result_out_of_range) {
        // from_chars leaves the value alone here; strtod tells overflow (infinity) from underflow (0 or
        // denormal).
        static const locale_t cLocale = newlocale(LC_ALL_MASK, "C", nullptr);
        value = strtod_l(std::string(begin, end).c_str(), nullptr, cLocale);
        return true;
    }
    return matches(code);
}

} // namespace

class CsvReader::Private {
public:
    ~Private() {
        if (file >= 0)
            ::close(file);
    }

    [[nodiscard]] const char* row() const { return buffer.data() + rowBegin; }
    [[nodiscard]] const char* rowEnd() const { return row() + rowLength; }

    [[nodiscard]] Unexpected systemError(ErrorKind kind, const QString& what, int code) const {
        return failed(kind, what.arg(QString::fromStdString(std::generic_category().message(code))), {},
                      {path});
    }

    [[nodiscard]] Unexpected badInput(const QString& message, const QString& expected,
                                      SourcePlace where) const {
        return failed(ErrorKind::badInput, message, expected, std::move(where));
    }

    [[nodiscard]] SourcePlace placeOf(const char* position) const {
        SourcePlace place{path, line, 1};
        for (const char* p = row(); p < position; ++p) {
            if (*p == '\n') {
                ++place.line;
                place.column = 1;
            } else if ((static_cast<unsigned char>(*p) & 0xC0U) != 0x80U) {
                ++place.column; // UTF-8 continuation bytes belong to the character before
            }
        }
        return place;
    }

    [[nodiscard]] Unexpected tooLong(const char* position) const {
        return badInput(CsvReaderText::tr("the row is too long: more than %1 values").arg(header.size()),
                        CsvReaderText::tr("one value per column: %1").arg(header.size()), placeOf(position));
    }

    [[nodiscard]] Unexpected tooShort(std::size_t values, const char* position) const {
        return badInput(
            CsvReaderText::tr("the row is too short: %1 of %2 values").arg(values).arg(header.size()),
            CsvReaderText::tr("one value per column: %1").arg(header.size()), placeOf(position));
    }

    [[nodiscard]] SourcePlace placeOfField(std::size_t index) const {
        const char* p = row();
        for (; index > 0; --index) {
            p = readField(p, rowEnd()).end;
            if (p == rowEnd())
                break;
            ++p;
        }
        return placeOf(p);
    }

    Expected<void> openFile();
    Expected<void> readHeader();
    Expected<void> fill();
    Expected<bool> readRow();
    Expected<double> slowField(const char* begin, const char*& end, bool allowNonFinite) const;

    std::string path;
    int file = -1;
    bool seekable = false;
    std::uint64_t size = 0;

    std::vector<char> buffer;
    std::uint64_t bufferOffset = 0; ///< file position of buffer[0]
    std::size_t begin = 0;          ///< next byte to read in the buffer
    std::size_t end = 0;            ///< bytes in the buffer
    bool atEnd = false;

    std::size_t rowBegin = 0;
    std::size_t rowLength = 0;
    long long line = 0;
    long long nextLine = 1;
    std::vector<std::string> header;
    std::deque<std::string> quoted; ///< texts of the last row that were in quotes
};

Expected<void> CsvReader::Private::openFile() {
    file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) {
        const int code = errno;
        if (code == EINTR)
            return systemError(ErrorKind::cancelled, CsvReaderText::tr("opening was interrupted: %1"), code);
        return systemError(code == ENOENT || code == ENOTDIR ? ErrorKind::notFound : ErrorKind::ioFailed,
                           CsvReaderText::tr("cannot open the file: %1"), code);
    }
    struct stat status = {};
    if (::fstat(file, &status) != 0)
        return systemError(ErrorKind::ioFailed, CsvReaderText::tr("cannot read the file: %1"), errno);
    if (S_ISDIR(status.st_mode))
        return badInput(CsvReaderText::tr("this is a folder"), CsvReaderText::tr("a CSV file"), {path});
    if (S_ISREG(status.st_mode)) {
        seekable = true;
        size = static_cast<std::uint64_t>(status.st_size);
        ::posix_fadvise(file, 0, 0, POSIX_FADV_SEQUENTIAL);
    }
    buffer.resize(kFirstBuffer);
    return {};
}

Expected<void> CsvReader::Private::readHeader() {
    TELETA_TRY(const bool any, readRow());
    if (!any)
        return badInput(CsvReaderText::tr("the file is empty"),
                        CsvReaderText::tr("a header line with the names of the columns"), {path, 1, 1});
    if (rowLength >= 2 && (std::memcmp(row(), "\xFF\xFE", 2) == 0 || std::memcmp(row(), "\xFE\xFF", 2) == 0))
        return badInput(CsvReaderText::tr("the file is UTF-16"), CsvReaderText::tr("UTF-8"), {path, 1, 1});
    for (const char* p = row();; ++p) {
        Field field = readField(p, rowEnd());
        if (!field.wellFormed)
            return badInput(CsvReaderText::tr("text outside the quotes of a column name"),
                            CsvReaderText::tr("a comma after the closing quote"), placeOf(p));
        header.push_back(std::move(field.text));
        p = field.end;
        if (p == rowEnd())
            break;
    }
    return {};
}

/// Gets more bytes behind the ones that are not used yet.
Expected<void> CsvReader::Private::fill() {
    if (begin > 0) {
        std::memmove(buffer.data(), buffer.data() + begin, end - begin);
        bufferOffset += begin;
        end -= begin;
        begin = 0;
    }
    if (end == buffer.size())
        buffer.resize(std::min(buffer.size() * 2, kMaximumLine + kFirstBuffer));
    const ssize_t count = ::read(file, buffer.data() + end, buffer.size() - end);
    if (count < 0) {
        const int code = errno;
        return systemError(code == EINTR ? ErrorKind::cancelled : ErrorKind::ioFailed,
                           CsvReaderText::tr("cannot read the file: %1"), code);
    }
    end += static_cast<std::size_t>(count);
    atEnd = count == 0;
    return {};
}

/// Finds the next row that is not empty. A line feed inside quotes belongs to the row.
Expected<bool> CsvReader::Private::readRow() {
    for (;;) {
        std::size_t scanned = 0;
        std::ptrdiff_t quotes = 0;
        const char* lineFeed = nullptr;
        for (;;) {
            const char* from = buffer.data() + begin + scanned;
            const std::size_t unscanned = end - begin - scanned;
            lineFeed =
                unscanned == 0 ? nullptr : static_cast<const char*>(std::memchr(from, '\n', unscanned));
            const char* to = lineFeed != nullptr ? lineFeed : from + unscanned;
            quotes += std::count(from, to, '"');
            scanned += static_cast<std::size_t>(to - from);
            if (scanned > kMaximumLine)
                return badInput(CsvReaderText::tr("the line is longer than 16 MiB"),
                                quotes % 2 != 0 ? CsvReaderText::tr("a closing quote")
                                                : CsvReaderText::tr("a line end"),
                                {path, nextLine});
            if (lineFeed != nullptr) {
                if (quotes % 2 == 0)
                    break;
                ++scanned;
            } else if (atEnd) {
                break;
            } else if (const Expected<void> filled = fill(); !filled) {
                return Unexpected(filled.error());
            }
        }
        if (scanned == 0 && lineFeed == nullptr)
            return false;

        if (bufferOffset + begin == 0 && scanned >= 3 && std::memcmp(buffer.data(), "\xEF\xBB\xBF", 3) == 0) {
            begin = 3;
            scanned -= 3;
        }
        rowBegin = begin;
        rowLength = scanned;
        line = nextLine;
        begin += scanned + (lineFeed != nullptr ? 1 : 0);
        nextLine += (lineFeed != nullptr ? 1 : 0) + (quotes > 0 ? std::count(row(), rowEnd(), '\n') : 0);
        if (quotes % 2 != 0)
            return badInput(CsvReaderText::tr("a quote is not closed"), CsvReaderText::tr("a closing quote"),
                            placeOf(std::find(row(), rowEnd(), '"')));
        if (rowLength > 0 && rowEnd()[-1] == '\r')
            --rowLength;
        if (!std::all_of(row(), rowEnd(), isBlank))
            return true;
    }
}

/// A field that is not a plain number followed by a comma: quoted, NA, out of range, or wrong.
Expected<double> CsvReader::Private::slowField(const char* begin_, const char*& end_,
                                               bool allowNonFinite) const {
    const Field field = readField(begin_, rowEnd());
    end_ = field.end;
    const QString wanted =
        allowNonFinite ? CsvReaderText::tr("a number, nan, inf or NA") : CsvReaderText::tr("a finite number");
    const char* text = field.text.c_str();
    double value = std::numeric_limits<double>::quiet_NaN();
    if (field.text.empty())
        return badInput(CsvReaderText::tr("the field is empty"), wanted, placeOf(begin_));
    if (!field.wellFormed || (field.text != "NA" && !parseNumber(text, text + field.text.size(), value)))
        return badInput(CsvReaderText::tr("%1 is not a number").arg(shown({begin_, field.end})), wanted,
                        placeOf(begin_));
    if (!allowNonFinite && !std::isfinite(value))
        return badInput(CsvReaderText::tr("%1 is not a finite number").arg(shown(field.text)), wanted,
                        placeOf(begin_));
    return value;
}

CsvReader::CsvReader(std::unique_ptr<Private> p)
    : d(std::move(p)) {
}
CsvReader::~CsvReader() = default;
CsvReader::CsvReader(CsvReader&&) noexcept = default;
CsvReader& CsvReader::operator=(CsvReader&&) noexcept = default;

Expected<CsvReader> CsvReader::open(const std::string& path) {
    auto d = std::make_unique<Private>();
    d->path = path;
    TELETA_CHECK(d->openFile());
    TELETA_CHECK(d->readHeader());
    return CsvReader(std::move(d));
}

const std::vector<std::string>& CsvReader::header() const {
    return d->header;
}

const std::string& CsvReader::path() const {
    return d->path;
}

Expected<std::size_t> CsvReader::column(std::string_view name) const {
    TELETA_TRY(const std::vector<std::size_t> found, columns({&name, 1}));
    return found.front();
}

Expected<std::vector<std::size_t>> CsvReader::columns(std::span<const std::string_view> names) const {
    std::vector<std::size_t> found;
    std::vector<std::string_view> missing;
    for (const std::string_view name : names) {
        const auto first = std::ranges::find(d->header, name);
        if (first == d->header.end()) {
            missing.push_back(name);
            continue;
        }
        if (std::find(first + 1, d->header.end(), name) != d->header.end())
            return d->badInput(CsvReaderText::tr("the column %1 appears twice").arg(shown(name)),
                               CsvReaderText::tr("each name only once"), {d->path, 1, 1});
        found.push_back(static_cast<std::size_t>(first - d->header.begin()));
    }
    if (!missing.empty())
        return d->badInput(CsvReaderText::tr("missing columns: %1; the file has: %2")
                               .arg(shownNames(missing), shownNames(d->header)),
                           CsvReaderText::tr("the columns %1").arg(shownNames(names)), {d->path, 1, 1});
    return found;
}

Expected<bool> CsvReader::next(std::vector<double>& values, bool allowNonFinite) {
    const Expected<bool> any = d->readRow();
    if (!any || !*any)
        return any;
    const std::size_t columns = d->header.size();
    values.resize(columns);
    const char* const rowEnd = d->rowEnd();
    const char* p = d->row();
    for (std::size_t i = 0;; ++i, ++p) {
        if (i == columns)
            return d->tooLong(p);
        const auto [stop, code] = std::from_chars(p, rowEnd, values[i]);
        if (matches(code) && (stop == rowEnd || *stop == ',') &&
            (allowNonFinite || std::isfinite(values[i]))) {
            p = stop;
        } else {
            TELETA_TRY(const double value, d->slowField(p, p, allowNonFinite));
            values[i] = value;
        }
        if (p == rowEnd) {
            if (i + 1 < columns)
                return d->tooShort(i + 1, p);
            return true;
        }
    }
}

Expected<bool> CsvReader::nextText(std::vector<std::string_view>& fields) {
    const Expected<bool> any = d->readRow();
    if (!any || !*any)
        return any;
    const std::size_t columns = d->header.size();
    fields.resize(columns);
    d->quoted.clear();
    const char* const rowEnd = d->rowEnd();
    const char* p = d->row();
    for (std::size_t i = 0;; ++i, ++p) {
        if (i == columns)
            return d->tooLong(p);
        const char* first = std::find_if_not(p, rowEnd, isBlank);
        if (first != rowEnd && *first == '"') {
            Field field = readField(p, rowEnd);
            if (!field.wellFormed)
                return d->badInput(CsvReaderText::tr("text outside the quotes of a value"),
                                   CsvReaderText::tr("a comma after the closing quote"), d->placeOf(p));
            p = field.end;
            fields[i] = d->quoted.emplace_back(std::move(field.text));
        } else {
            const void* comma = std::memchr(first, ',', static_cast<std::size_t>(rowEnd - first));
            p = comma != nullptr ? static_cast<const char*>(comma) : rowEnd;
            const char* last = p;
            while (last > first && isBlank(last[-1]))
                --last;
            fields[i] = {first, static_cast<std::size_t>(last - first)};
        }
        if (p == rowEnd) {
            if (i + 1 < columns)
                return d->tooShort(i + 1, p);
            return true;
        }
    }
}

SourcePlace CsvReader::place(std::size_t column) const {
    return d->placeOfField(column);
}

long long CsvReader::line() const {
    return d->line;
}

long long CsvReader::nextLine() const {
    return d->nextLine;
}

std::uint64_t CsvReader::bytesRead() const {
    return d->bufferOffset + d->begin;
}

std::uint64_t CsvReader::bytesTotal() const {
    return d->size;
}

Expected<void> CsvReader::seek(std::uint64_t byteOffset, long long line) {
    if (!d->seekable)
        return failed(ErrorKind::refused, CsvReaderText::tr("a pipe cannot be rewound"),
                      CsvReaderText::tr("a file"), {d->path});
    if (byteOffset >= d->bufferOffset && byteOffset - d->bufferOffset <= d->end) {
        d->begin = static_cast<std::size_t>(byteOffset - d->bufferOffset);
    } else {
        if (::lseek(d->file, static_cast<off_t>(byteOffset), SEEK_SET) < 0)
            return d->systemError(ErrorKind::ioFailed, CsvReaderText::tr("cannot read the file: %1"), errno);
        d->bufferOffset = byteOffset;
        d->begin = 0;
        d->end = 0;
    }
    d->atEnd = false;
    d->rowBegin = d->begin;
    d->rowLength = 0;
    d->line = line;
    d->nextLine = line;
    return {};
}

} // namespace teleta::core
