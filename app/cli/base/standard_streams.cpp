// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/base/standard_streams.h"

#include <QCoreApplication>
#include <QFile>
#include <QTemporaryDir>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <utility>

namespace teleta::cli {

namespace {

struct StandardStreamText {
    Q_DECLARE_TR_FUNCTIONS(StandardStreamText)
};

/// What "-" has been taken for so far; there is one of each stream.
struct Taken {
    bool input = false;
    bool output = false;
    std::unique_ptr<QTemporaryDir> folder;
};
Taken& taken() {
    static Taken streams;
    return streams;
}

/// Ending of a file that is read as a whole, by the name of its option; CSV is read while it comes.
constexpr auto kWhole = std::to_array<std::pair<std::string_view, std::string_view>>({{"scene", "toml"},
                                                                                      {"protocol", "toml"},
                                                                                      {"camera", "json"},
                                                                                      {"--camera", "json"},
                                                                                      {"pattern", "json"},
                                                                                      {"--motors", "json"},
                                                                                      {"inputs", "csv"}});

bool isOutput(std::string_view name) {
    constexpr std::array<std::string_view, 4> kOutputs{"--out", "--curve", "--residuals", "out"};
    return std::ranges::any_of(kOutputs, [&](std::string_view output) { return name.ends_with(output); });
}

bool isRead(std::string_view name, std::string_view type) {
    return name == "FRAMES" || name.ends_with(".csv") || type.find(".csv") != std::string_view::npos ||
           type.substr(0, type.find('|')) == "FILE";
}

std::string error(const QString& text) {
    return text.toStdString();
}

/// Copies standard input into a file. An error, or nothing.
std::string copyInput(std::string& path, std::string_view ending) {
    taken().folder = std::make_unique<QTemporaryDir>();
    const QString copy =
        taken().folder->filePath(QStringLiteral("standard-input.") +
                                 QString::fromLatin1(ending.data(), static_cast<qsizetype>(ending.size())));
    QFile input;
    QFile file(copy);
    constexpr qint64 kMost = 256 << 20;
    if (!input.open(stdin, QIODevice::ReadOnly) || !file.open(QIODevice::WriteOnly))
        return error(StandardStreamText::tr("standard input cannot be read"));
    qint64 copied = 0;
    while (true) {
        const QByteArray piece = input.read(1 << 16);
        if (piece.isEmpty())
            break;
        copied += piece.size();
        if (copied > kMost || file.write(piece) != piece.size())
            return error(StandardStreamText::tr("standard input is too large"));
    }
    path = copy.toStdString();
    return {};
}

std::string takeInput(std::string& path, std::optional<std::string_view> wholeEnding) {
    if (std::exchange(taken().input, true))
        return error(StandardStreamText::tr("standard input can be read only once"));
    if (wholeEnding)
        return copyInput(path, *wholeEnding);
    path = "/dev/stdin";
    return {};
}

std::string takeOutput(std::string& path) {
    if (std::exchange(taken().output, true))
        return error(StandardStreamText::tr("standard output can be written only once"));
    path = kStandardOutput;
    return {};
}

} // namespace

void acceptDash(CLI::Option& option, std::string_view name, std::string_view type) {
    const auto translate = [name = std::string(name), type = std::string(type)](std::string& path) {
        if (path != "-")
            return std::string();
        if (type == "DIR")
            return error(StandardStreamText::tr("- is given, a folder is expected"));
        if (name == "RECORDING" || name == "--mcap" || type.find(".teleta") != std::string::npos)
            return error(StandardStreamText::tr("a recording is a database, which is no stream"));
        if (name == "--npz")
            return error(StandardStreamText::tr("an npz file is an archive, which is no stream"));
        if (name == "video")
            return error(StandardStreamText::tr("a video cannot be read from standard input"));
        if (isOutput(name))
            return takeOutput(path);
        const auto whole =
            std::ranges::find(kWhole, name, &std::pair<std::string_view, std::string_view>::first);
        if (whole != kWhole.end())
            return takeInput(path, whole->second);
        return isRead(name, type) ? takeInput(path, std::nullopt) : std::string();
    };
    option.transform(CLI::Validator(translate, std::string()));
}

void refuseTwoOutputs(const CLI::App& command) {
    for (const CLI::App* part : command.get_subcommands())
        refuseTwoOutputs(*part);
    const CLI::Option* json = command.get_option_no_throw("--json");
    if (taken().output && json != nullptr && json->count() > 0)
        throw CLI::ValidationError(
            "--json",
            StandardStreamText::tr("the document and a file would both go to standard output").toStdString());
}

bool standardOutputIsFile() {
    return taken().output;
}

} // namespace teleta::cli
