// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/faults/fault_log.h"

#include <cstddef>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace teleta::test {

/// What of the changes that were not yet synced a power cut leaves on the disk.
enum class Leftover {
    all,      ///< everything, as after a kill
    nothing,  ///< only what was synced
    anything, ///< any sectors of any writes, and any first part of the changes of names
};

/// A disk as POSIX promises it, and no better: the bytes of a file last from a sync of the file on, its name
/// from a sync of its folder on. Names change in their order, as file systems with a journal have it.
/// Thread: one.
class DiskModel {
public:
    explicit DiskModel(std::string root)
        : m_root(std::move(root)) {}

    void apply(const FileOp& op);

    /// Files with their bytes after a cut; only of folders that lasted.
    [[nodiscard]] std::map<std::string, std::string> cut(Leftover leftover, std::mt19937_64& random) const;
    /// Folders after the cut that cut() showed last.
    [[nodiscard]] const std::set<std::string>& folders() const { return m_foldersLeft; }

private:
    static constexpr std::size_t kSector = 512;

    struct File {
        std::string durable;
        std::vector<FileOp> pending; ///< writes and truncations since its last sync
    };
    /// A change of names.
    struct NameOp {
        std::string folder;              ///< in which it happens
        std::string name;                ///< whole path
        std::optional<std::size_t> file; ///< that has the name from now on; empty: none
        bool makesFolder = false;
        std::string gone; ///< other name that goes at the same time; empty: none
    };
    struct Names {
        std::map<std::string, std::size_t> files;
        std::set<std::string> folders;
        void apply(const NameOp& op);
    };

    [[nodiscard]] static std::string folderOf(const std::string& path) {
        return path.substr(0, path.rfind('/'));
    }
    static void change(std::string& bytes, const FileOp& op);
    void name(NameOp op);
    [[nodiscard]] std::string left(const File& file, Leftover leftover, std::mt19937_64& random) const;

    std::string m_root;
    std::vector<File> m_files;
    std::map<std::string, std::size_t> m_nameless;
    Names m_now;
    Names m_durable;
    std::vector<NameOp> m_pending;
    mutable std::set<std::string> m_foldersLeft;
};

} // namespace teleta::test
