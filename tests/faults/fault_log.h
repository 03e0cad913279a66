// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace teleta::test {

/// One change of a file, as faulty_files.cpp writes it down.
struct FileOp {
    enum class Kind : std::uint8_t {
        create,   ///< other: "nameless" for one that is linked later
        write,    ///< data at offset
        truncate, ///< to offset bytes
        sync,     ///< of a file or a folder
        rename,   ///< path to other
        link,     ///< path, which has no name, to other
        unlink,
        folder,
    };
    Kind kind = Kind::write;
    std::string path;
    std::string other;
    std::int64_t offset = 0;
    std::string data;
};

inline void append(std::string& bytes, std::string_view text) {
    const auto size = static_cast<std::uint32_t>(text.size());
    bytes.append(reinterpret_cast<const char*>(&size), sizeof size);
    bytes.append(text);
}

[[nodiscard]] inline std::string encoded(const FileOp& op) {
    std::string bytes(1, static_cast<char>(op.kind));
    append(bytes, op.path);
    append(bytes, op.other);
    bytes.append(reinterpret_cast<const char*>(&op.offset), sizeof op.offset);
    append(bytes, op.data);
    return bytes;
}

/// Of the operations that were encoded one after the other; a last one that was cut is left out.
[[nodiscard]] inline std::vector<FileOp> decoded(std::string_view bytes) {
    std::vector<FileOp> ops;
    const auto take = [&bytes](void* to, std::size_t size) {
        if (bytes.size() < size)
            return false;
        std::memcpy(to, bytes.data(), size);
        bytes.remove_prefix(size);
        return true;
    };
    const auto takeText = [&](std::string& text) {
        std::uint32_t size = 0;
        if (!take(&size, sizeof size) || bytes.size() < size)
            return false;
        text.assign(bytes.substr(0, size));
        bytes.remove_prefix(size);
        return true;
    };
    for (FileOp op; take(&op.kind, sizeof op.kind) && takeText(op.path) && takeText(op.other) &&
                    take(&op.offset, sizeof op.offset) && takeText(op.data);
         op = {})
        ops.push_back(op);
    return ops;
}

} // namespace teleta::test
