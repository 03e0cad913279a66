// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/faults/disk_model.h"

#include <algorithm>
#include <random>

namespace teleta::test {

void DiskModel::Names::apply(const NameOp& op) {
    if (op.makesFolder)
        folders.insert(op.name);
    else if (op.file)
        files[op.name] = *op.file;
    else
        files.erase(op.name);
    if (!op.gone.empty())
        files.erase(op.gone);
}

void DiskModel::change(std::string& bytes, const FileOp& op) {
    const auto offset = static_cast<std::size_t>(op.offset);
    if (op.kind == FileOp::Kind::truncate) {
        bytes.resize(offset);
        return;
    }
    bytes.resize(std::max(bytes.size(), offset + op.data.size()));
    bytes.replace(offset, op.data.size(), op.data);
}

void DiskModel::name(NameOp op) {
    op.folder = folderOf(op.name);
    m_now.apply(op);
    m_pending.push_back(std::move(op));
}

void DiskModel::apply(const FileOp& op) {
    const auto fileAt = [this](const std::string& path) -> std::optional<std::size_t> {
        if (const auto found = m_now.files.find(path); found != m_now.files.end())
            return found->second;
        if (const auto found = m_nameless.find(path); found != m_nameless.end())
            return found->second;
        return std::nullopt;
    };
    switch (op.kind) {
    case FileOp::Kind::create:
        m_files.emplace_back();
        if (op.other == "nameless")
            m_nameless[op.path] = m_files.size() - 1;
        else
            name({.folder = {},
                  .name = op.path,
                  .file = m_files.size() - 1,
                  .makesFolder = false,
                  .gone = {}});
        return;
    case FileOp::Kind::write:
    case FileOp::Kind::truncate:
        if (const auto file = fileAt(op.path))
            m_files[*file].pending.push_back(op);
        return;
    case FileOp::Kind::sync:
        if (const auto file = fileAt(op.path)) {
            for (const FileOp& pending : std::exchange(m_files[*file].pending, {}))
                change(m_files[*file].durable, pending);
            return;
        }
        // Of a folder: the changes in it.
        std::erase_if(m_pending, [&](const NameOp& pending) {
            if (pending.folder != op.path)
                return false;
            m_durable.apply(pending);
            return true;
        });
        return;
    case FileOp::Kind::rename:
        name(
            {.folder = {}, .name = op.other, .file = fileAt(op.path), .makesFolder = false, .gone = op.path});
        return;
    case FileOp::Kind::link:
        name({.folder = {}, .name = op.other, .file = fileAt(op.path), .makesFolder = false, .gone = {}});
        return;
    case FileOp::Kind::unlink:
        name({.folder = {}, .name = op.path, .file = std::nullopt, .makesFolder = false, .gone = {}});
        return;
    case FileOp::Kind::folder:
        name({.folder = {}, .name = op.path, .file = std::nullopt, .makesFolder = true, .gone = {}});
        return;
    }
}

std::string DiskModel::left(const File& file, Leftover leftover, std::mt19937_64& random) const {
    std::string bytes = file.durable;
    if (leftover == Leftover::nothing)
        return bytes;
    for (const FileOp& op : file.pending) {
        if (leftover == Leftover::all) {
            change(bytes, op);
        } else if (op.kind == FileOp::Kind::truncate) {
            if (random() % 2 == 0)
                change(bytes, op);
        } else {
            // Each sector for itself.
            for (std::size_t done = 0; done < op.data.size();) {
                const std::size_t offset = static_cast<std::size_t>(op.offset) + done;
                const std::size_t size = std::min(op.data.size() - done, kSector - offset % kSector);
                FileOp part;
                part.offset = static_cast<std::int64_t>(offset);
                part.data = op.data.substr(done, size);
                if (random() % 2 == 0)
                    change(bytes, part);
                done += size;
            }
        }
    }
    return bytes;
}

std::map<std::string, std::string> DiskModel::cut(Leftover leftover, std::mt19937_64& random) const {
    Names names = m_durable;
    const std::size_t kept = leftover == Leftover::all       ? m_pending.size()
                             : leftover == Leftover::nothing ? 0
                                                             : random() % (m_pending.size() + 1);
    for (std::size_t k = 0; k < kept; ++k)
        names.apply(m_pending[k]);
    m_foldersLeft = {m_root};
    // Outer folders come first in their order.
    for (const std::string& folder : names.folders)
        if (m_foldersLeft.contains(folderOf(folder)))
            m_foldersLeft.insert(folder);
    std::map<std::string, std::string> files;
    for (const auto& [path, file] : names.files)
        if (m_foldersLeft.contains(folderOf(path)))
            files[path] = left(m_files[file], leftover, random);
    return files;
}

} // namespace teleta::test
