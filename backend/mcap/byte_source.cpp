// SPDX-License-Identifier: GPL-3.0-or-later
#include "backend/mcap/byte_source.h"

#include "backend/core/failure.h"

#include <QCoreApplication>
#include <QFile>

#include <utility>

namespace teleta::mcap {

namespace {

struct McapFileText {
    Q_DECLARE_TR_FUNCTIONS(McapFile)
};

class FileSource : public ByteSource {
public:
    explicit FileSource(std::unique_ptr<QFile> file)
        : m_file(std::move(file))
        , m_size(static_cast<std::uint64_t>(m_file->size())) {}

    [[nodiscard]] std::uint64_t size() const override { return m_size; }

    [[nodiscard]] bool read(std::uint64_t at, std::size_t size, std::string& bytes) override {
        if (at > m_size || size > m_size - at || !m_file->seek(static_cast<qint64>(at)))
            return false;
        bytes.resize(size);
        std::size_t done = 0;
        while (done < size) {
            const qint64 count = m_file->read(bytes.data() + done, static_cast<qint64>(size - done));
            if (count <= 0)
                return false;
            done += static_cast<std::size_t>(count);
        }
        return true;
    }

private:
    std::unique_ptr<QFile> m_file;
    std::uint64_t m_size;
};

class TextSource : public ByteSource {
public:
    explicit TextSource(std::string_view text)
        : m_text(text) {}

    [[nodiscard]] std::uint64_t size() const override { return m_text.size(); }

    [[nodiscard]] bool read(std::uint64_t at, std::size_t size, std::string& bytes) override {
        if (at > m_text.size() || size > m_text.size() - at)
            return false;
        bytes.assign(m_text.substr(static_cast<std::size_t>(at), size));
        return true;
    }

private:
    std::string_view m_text;
};

} // namespace

core::Expected<std::unique_ptr<ByteSource>> openFile(const std::string& path) {
    auto file = std::make_unique<QFile>(QString::fromStdString(path));
    if (!file->exists())
        return core::failed(core::ErrorKind::notFound, McapFileText::tr("there is no such file"), {}, {path});
    if (!file->open(QIODevice::ReadOnly | QIODevice::Unbuffered))
        return core::failed(core::ErrorKind::ioFailed,
                            McapFileText::tr("cannot be opened: %1").arg(file->errorString()), {}, {path});
    return std::make_unique<FileSource>(std::move(file));
}

std::unique_ptr<ByteSource> bytesOf(std::string_view text) {
    return std::make_unique<TextSource>(text);
}

} // namespace teleta::mcap
