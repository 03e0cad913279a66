// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/taxels/taxels_file.h"

#include "backend/core/beside_file.h"
#include "backend/core/keys/toml_keys.h"
#include "devices/taxels/frame_keys.h"
#include "devices/taxels/frames/frame_decoder.h"
#include "devices/taxels/magnetometers_file.h"
#include "devices/taxels/taxels_text.h"
#include "devices/taxels/xela_file.h"

#include <QString>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace teleta::taxels {

namespace {

using core::Keys;
using core::Need;
using core::NumberRange;

constexpr double kThreshold_N = 0.2;
constexpr int kMostRestFrames = 10'000;
constexpr std::array<std::string_view, 3> kArrayKinds{"taxels", "magnetometers", "xela"};

void describeSerial(Keys& keys, link::SerialAddress& serial) {
    keys.text("path", serial.path, "Path of the serial port, or of the file");
    keys.whole("baud", serial.baud, {9600, 4'000'000}, "Bits a second", Need::optional);
    keys.choice("parity", serial.parity, {"none", "even", "odd"}, "Parity bit", Need::optional);
    keys.whole("stop_bits", serial.stopBits, {1, 2}, "Stop bits", Need::optional);
}

void describeTcp(Keys& keys, link::TcpAddress& tcp) {
    keys.text("host", tcp.host, "Name or address of the sensor");
    keys.whole("port", tcp.port, {1, 65535}, "Its port, or the one of this computer to which it sends");
}

void describeUdp(Keys& keys, link::UdpAddress& udp) {
    keys.whole("port", udp.port, {1, 65535}, "Its port, or the one of this computer to which it sends");
    keys.text("from", udp.from, "The only host whose datagrams are taken; otherwise this computer",
              Need::optional);
}

void describeWeb(Keys& keys, link::WebAddress& web) {
    describeWebAddress(keys, web.url, "Its address, as `ws://HOST:PORT`", Need::required);
}

void describeFile(Keys& keys, link::FileAddress& file) {
    keys.text("path", file.path, "Path of the serial port, or of the file");
}

/// What is sent, as text or as hexadecimal bytes.
void describeWords(Keys& keys, const std::string& key, std::string& words, std::string_view about) {
    const std::string bytesKey = key + "_bytes";
    keys.text(key, words, about, Need::optional);
    std::vector<std::uint8_t> bytes;
    describeBytes(keys, bytesKey, bytes, "The same as hexadecimal bytes, as `AA 55`");
    if (!bytes.empty() && !words.empty())
        refuse(keys, bytesKey, TaxelsText::tr("it is given as text already"),
               TaxelsText::tr("either %1 or %2")
                   .arg(QString::fromStdString(key), QString::fromStdString(bytesKey)));
    else if (!bytes.empty())
        words.assign(bytes.begin(), bytes.end());
}

void describeLink(Keys& keys, TaxelsFile& file) {
    link::Address& address = file.address;
    keys.choose(
        "type", address.index(),
        {{"serial", "A serial port"},
         {"tcp", "A connection to the sensor"},
         {"udp", "Datagrams to this computer, each one frame"},
         {"websocket", "A WebSocket server, each of whose messages is one frame"},
         {"file", "Bytes that were kept in a file, or that another program writes into a named pipe"}},
        "How the sensor is reached", Need::required, [&](Keys& chosen, std::size_t index) {
            if (index == 0)
                describeSerial(chosen, address.emplace<link::SerialAddress>());
            else if (index == 1)
                describeTcp(chosen, address.emplace<link::TcpAddress>());
            else if (index == 2)
                return describeUdp(chosen, address.emplace<link::UdpAddress>());
            else if (index == 3)
                describeWeb(chosen, address.emplace<link::WebAddress>());
            else
                return describeFile(chosen, address.emplace<link::FileAddress>());
            describeWords(chosen, "greeting", file.greeting,
                          "Text that is sent to the sensor when the link is open");
            describeWords(chosen, "goodbye", file.goodbye, "Text that is sent before the link is closed");
        });
}

template <typename File>
core::Expected<TaxelsFile> readAs(const core::TomlDocument& document) {
    return core::readKeys<File>(document).map([](File file) { return std::move(file.taxels); });
}

core::Expected<TaxelsFile> readKind(const core::TomlDocument& document) {
    core::TomlTable root = document.root();
    // Without a kind, reading as the first one says what is missing.
    const std::size_t kind =
        root.has("kind") ? root.choice("kind", {kArrayKinds.begin(), kArrayKinds.end()}) : 0;
    if (document.firstError())
        return core::Unexpected(*document.firstError());
    if (kind == 1)
        return readAs<MagnetometersFile>(document);
    if (kind == 2)
        return readAs<XelaFile>(document);
    return core::readKeys<TaxelsFile>(document);
}

core::Expected<TaxelsFile> read(const core::TomlDocument& document, const std::string& path) {
    TELETA_TRY(TaxelsFile file, readKind(document));
    if (auto* serial = std::get_if<link::SerialAddress>(&file.address))
        serial->path = core::besideFile(path, serial->path);
    else if (auto* kept = std::get_if<link::FileAddress>(&file.address))
        kept->path = core::besideFile(path, kept->path);
    if (!file.loads.empty())
        file.loads = core::besideFile(path, file.loads);
    return file;
}

} // namespace

void TaxelsFile::describeKeys(core::Keys& keys) {
    keys.word("kind", "taxels", "An array that this file describes");
    keys.text("name", name, "Name on the screen");
    keys.number(
        "rate_Hz", rate_Hz, NumberRange::between(0.0, 1e5),
        "Frames a second that the sensor sends, or that are taken from a file; 0: not known, or as fast "
        "as possible",
        Need::optional);
    keys.number("threshold", threshold, NumberRange::positive(),
                "Load above which a taxel counts as touched; otherwise 0.2 N, if the unit is N");
    keys.whole("rest_frames", restFrames, {0, kMostRestFrames},
               "Frames read at opening; their median becomes the tare; 0: no tare", Need::optional);
    describeLoads(keys);
    keys.table("link", "How the sensor is reached", Need::required,
               [this](Keys& table) { describeLink(table, *this); });
    keys.table("layout", "Where the taxels are", Need::required,
               [this](Keys& table) { grid.describeKeys(table); });
    keys.table("frame", "How the bytes form frames", Need::required, [this](Keys& table) {
        describeFrame(table, format, static_cast<std::size_t>(grid.components()));
        if (const std::size_t count = valuesOf(format); count != grid.values())
            refuse(table, "encoding",
                   TaxelsText::tr("a frame has %1 numbers, but the layout has %2 taxels with %3 each")
                       .arg(count)
                       .arg(grid.taxels())
                       .arg(grid.components()),
                   TaxelsText::tr("%1 numbers").arg(grid.values()));
    });
    if (!threshold && grid.loadUnit() != "N")
        refuseWithoutThreshold(keys);
}

void TaxelsFile::describeLoads(core::Keys& keys) {
    keys.text(
        "loads", loads,
        "Calibration that `teleta loads fit` has written: each frame has its loads in N with their errors",
        Need::optional);
}

double TaxelsFile::touchedFrom() const {
    return threshold.value_or(kThreshold_N);
}

bool isArrayKind(std::string_view kind) {
    return std::ranges::find(kArrayKinds, kind) != kArrayKinds.end();
}

core::Expected<TaxelsFile> readTaxels(const std::string& path) {
    TELETA_TRY(const auto document, core::TomlDocument::open(path));
    return read(document, path);
}

core::Expected<TaxelsFile> parseTaxels(std::string_view text, const std::string& file) {
    TELETA_TRY(const auto document, core::TomlDocument::parse(text, file));
    return read(document, file);
}

} // namespace teleta::taxels
