// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/core/data/json_document.h"

#include "backend/core/failure.h"
#include "backend/core/number_text.h"

#include <QCoreApplication>

#include <set>
#include <utility>
#include <vector>

namespace teleta::core {

namespace {

using nlohmann::ordered_json;

struct JsonText {
    Q_DECLARE_TR_FUNCTIONS(JsonDocument)
};

QString digits(double value) {
    return QString::fromStdString(std::string(NumberText(value).view()));
}

/// Line and column in characters, from 1.
SourcePlace placeOf(const std::string& file, const std::string& text, std::size_t offset) {
    SourcePlace place{file, 1, 1};
    for (std::size_t i = 0; i < std::min(offset, text.size()); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        if (byte == '\n') {
            ++place.line;
            place.column = 1;
        } else if ((byte & 0xC0U) != 0x80U) {
            ++place.column;
        }
    }
    return place;
}

/// Finds the first bracket that is too deep; strings are left out. Works on any text.
std::optional<std::size_t> tooDeep(const std::string& text) {
    int depth = 0;
    bool inString = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (inString) {
            if (c == '\\')
                ++i;
            else if (c == '"')
                inString = false;
        } else if (c == '"') {
            inString = true;
        } else if (c == '{' || c == '[') {
            if (++depth > JsonDocument::kDeepest)
                return i;
        } else if (c == '}' || c == ']') {
            --depth;
        }
    }
    return std::nullopt;
}

/// Looks where a text stops being JSON, and for keys that are there twice, which a parser would lose.
struct Inspection : nlohmann::json_sax<ordered_json> {
    std::optional<std::size_t> damage;
    std::optional<std::string> repeated;
    std::vector<std::set<std::string>> keys;

    bool null() override { return true; }
    bool boolean(bool) override { return true; }
    bool number_integer(number_integer_t) override { return true; }
    bool number_unsigned(number_unsigned_t) override { return true; }
    bool number_float(number_float_t, const string_t&) override { return true; }
    bool string(string_t&) override { return true; }
    bool binary(binary_t&) override { return true; }
    bool start_object(std::size_t) override {
        keys.emplace_back();
        return true;
    }
    bool key(string_t& name) override {
        if (keys.back().insert(name).second)
            return true;
        repeated = name;
        return false;
    }
    bool end_object() override {
        keys.pop_back();
        return true;
    }
    bool start_array(std::size_t) override { return true; }
    bool end_array() override { return true; }
    bool parse_error(std::size_t position, const std::string&, const nlohmann::detail::exception&) override {
        damage = position > 0 ? position - 1 : 0;
        return false;
    }
};

/// Steps through a text that is known to be JSON.
class Scanner {
public:
    explicit Scanner(const std::string& text)
        : m_text(text) {}

    [[nodiscard]] std::size_t position() const { return m_at; }

    void skipBlanks() {
        while (m_at < m_text.size() && std::string_view(" \t\r\n").find(m_text[m_at]) != std::string::npos)
            ++m_at;
    }
    void enter() {
        ++m_at;
        skipBlanks();
    }
    void skipValue() {
        int depth = 0;
        do {
            const char c = m_text[m_at];
            if (c == '"') {
                skipString();
                continue;
            }
            if (c == '{' || c == '[')
                ++depth;
            else if (c == '}' || c == ']')
                --depth;
            ++m_at;
        } while (m_at < m_text.size() &&
                 (depth > 0 || std::string_view(",]} \t\r\n:").find(m_text[m_at]) == std::string::npos));
        skipBlanks();
    }
    /// To the value behind the comma that comes next.
    void skipElement() {
        skipValue();
        enter();
    }
    /// Members are in the order of the text.
    void skipKey() {
        skipString();
        skipBlanks();
        enter(); // the colon
    }

private:
    void skipString() {
        for (++m_at; m_text[m_at] != '"'; ++m_at) {
            if (m_text[m_at] == '\\')
                ++m_at;
        }
        ++m_at;
    }

    const std::string& m_text;
    std::size_t m_at = 0;
};

/// Numbers of the children that lead from here to the value; false when it is not below.
bool findWay(const ordered_json& from, const ordered_json* to, std::vector<std::size_t>& way) {
    if (&from == to)
        return true;
    if (!from.is_structured())
        return false;
    way.push_back(0);
    for (const ordered_json& child : from) {
        if (findWay(child, to, way))
            return true;
        ++way.back();
    }
    way.pop_back();
    return false;
}

const ordered_json kNull;
const ordered_json kEmptyArray = ordered_json::array();

} // namespace

Expected<JsonDocument> JsonDocument::parse(std::string text, const std::string& file) {
    const auto failure = [&](std::optional<std::size_t> offset, const QString& message,
                             const QString& expected) {
        return failed(ErrorKind::badInput, message, expected,
                      offset ? placeOf(file, text, *offset) : SourcePlace{file, 0, 0});
    };
    if (text.size() > kMostBytes)
        return failure({}, JsonText::tr("the file is too large"),
                       JsonText::tr("at most %1 MiB").arg(kMostBytes >> 20U));
    if (const std::optional<std::size_t> offset = tooDeep(text))
        return failure(offset, JsonText::tr("the values are nested too deeply"),
                       JsonText::tr("at most %1 levels").arg(kDeepest));
    Inspection inspection;
    if (!ordered_json::sax_parse(text, &inspection)) {
        if (inspection.repeated)
            return failure({},
                           JsonText::tr("an object has the key \"%1\" twice")
                               .arg(QString::fromStdString(*inspection.repeated)),
                           JsonText::tr("each key once"));
        return failure(inspection.damage, JsonText::tr("the JSON text is damaged or truncated"),
                       JsonText::tr("JSON in UTF-8"));
    }
    JsonDocument document;
    document.m_file = file;
    document.m_root = std::make_unique<ordered_json>(ordered_json::parse(text));
    document.m_text = std::move(text);
    return document;
}

Error JsonDocument::errorAt(const ordered_json& value, const QString& message,
                            const QString& expected) const {
    Error error{ErrorKind::badInput, message.toStdString(), expected.toStdString(), {m_file}};
    std::vector<std::size_t> way;
    if (!findWay(*m_root, &value, way))
        return error;
    Scanner scanner(m_text);
    scanner.skipBlanks();
    std::string path;
    const ordered_json* here = m_root.get();
    for (const std::size_t child : way) {
        scanner.enter();
        for (std::size_t i = 0; i < child; ++i) {
            if (here->is_object())
                scanner.skipKey();
            scanner.skipElement();
        }
        auto next = here->begin();
        std::advance(next, static_cast<std::ptrdiff_t>(child));
        if (!path.empty())
            path += '/';
        if (here->is_object()) {
            scanner.skipKey();
            path += next.key();
        } else {
            path += std::to_string(child);
        }
        here = &*next;
    }
    error.where = placeOf(m_file, m_text, scanner.position());
    if (!path.empty())
        error.message = JsonText::tr("%1: %2").arg(QString::fromStdString(path), message).toStdString();
    return error;
}

std::string jsonText(const ordered_json& value) {
    return value.dump(2, ' ', false, ordered_json::error_handler_t::replace) + '\n';
}

void JsonReader::fail(Value value, const QString& message, const QString& expected) {
    if (!m_error)
        m_error = m_document.errorAt(value, message, expected);
}

const ordered_json* JsonReader::find(Value object, const char* key) {
    if (m_error)
        return nullptr;
    if (!object.is_object()) {
        fail(object, JsonText::tr("this is not an object"),
             JsonText::tr("an object with the key \"%1\"").arg(QLatin1String(key)));
        return nullptr;
    }
    const auto found = object.find(key);
    return found == object.end() ? nullptr : &*found;
}

JsonReader::Value JsonReader::member(Value object, const char* key) {
    const ordered_json* found = find(object, key);
    if (found != nullptr)
        return *found;
    fail(object, JsonText::tr("the key \"%1\" is missing").arg(QLatin1String(key)), {});
    return kNull;
}

JsonReader::Value JsonReader::array(Value value, std::size_t atLeast, std::size_t atMost) {
    if (m_error)
        return kEmptyArray;
    if (value.is_array() && value.size() >= atLeast && value.size() <= atMost)
        return value;
    const QString expected = atLeast == atMost
                                 ? JsonText::tr("an array of length %1").arg(atLeast)
                                 : JsonText::tr("an array of length %1 to %2").arg(atLeast).arg(atMost);
    fail(value,
         value.is_array() ? JsonText::tr("the array has the wrong length")
                          : JsonText::tr("this is not an array"),
         expected);
    return kEmptyArray;
}

double JsonReader::number(Value value, double lower, double upper) {
    if (m_error)
        return lower;
    const auto expected = [&] {
        return JsonText::tr("a number from %1 to %2").arg(digits(lower), digits(upper));
    };
    if (!value.is_number()) {
        fail(value, JsonText::tr("this is not a number"), expected());
        return lower;
    }
    const auto found = value.get<double>();
    if (found >= lower && found <= upper)
        return found;
    fail(value, JsonText::tr("%1 is out of range").arg(digits(found)), expected());
    return lower;
}

double JsonReader::number(Value object, const char* key, double lower, double upper, double missing) {
    const ordered_json* found = find(object, key);
    return found == nullptr ? missing : number(*found, lower, upper);
}

long long JsonReader::integer(Value value, long long lower, long long upper) {
    // The largest number of 64 bits is none of a double: what is rounded up to 2^63 is out of range.
    constexpr double kBeyond = 9223372036854775808.0;
    const double found = number(value, static_cast<double>(lower), static_cast<double>(upper));
    const auto whole = found < kBeyond ? static_cast<long long>(found) : upper;
    if (found >= kBeyond || static_cast<double>(whole) != found)
        fail(value, JsonText::tr("this is not a whole number"),
             JsonText::tr("a whole number from %1 to %2").arg(lower).arg(upper));
    return whole;
}

bool JsonReader::boolean(Value object, const char* key, bool missing) {
    const ordered_json* found = find(object, key);
    if (found == nullptr)
        return missing;
    if (!found->is_boolean()) {
        fail(*found, JsonText::tr("this is neither true nor false"), "true, false");
        return missing;
    }
    return found->get<bool>();
}

std::string JsonReader::text(Value value) {
    if (m_error)
        return {};
    if (!value.is_string()) {
        fail(value, JsonText::tr("this is not text"), JsonText::tr("text"));
        return {};
    }
    return value.get<std::string>();
}

std::string JsonReader::text(Value object, const char* key, const std::string& missing) {
    const ordered_json* found = find(object, key);
    return found == nullptr ? missing : text(*found);
}

} // namespace teleta::core
