// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <sys/mount.h>
#include <unistd.h>
#include <vector>

namespace teleta::test {

/// A separate memory disk mounted in a folder that can be filled to its last byte; not available where
/// mounting is not allowed.
class SmallDisk {
public:
    SmallDisk(const std::string& folder, std::size_t size_MB)
        : m_folder(folder) {
        std::filesystem::create_directories(folder);
        const std::string size = "size=" + std::to_string(size_MB) + "m";
        m_exists = mount("none", folder.c_str(), "tmpfs", 0, size.c_str()) == 0;
    }
    ~SmallDisk() {
        // Its files may still be open for a moment.
        if (m_exists)
            (void)umount2(m_folder.c_str(), MNT_DETACH);
    }
    SmallDisk(const SmallDisk&) = delete;
    SmallDisk& operator=(const SmallDisk&) = delete;

    [[nodiscard]] bool exists() const { return m_exists; }
    [[nodiscard]] std::string path(const std::string& name) const { return m_folder + "/" + name; }

    /// Fills all remaining space. Returns false when some is left.
    [[nodiscard]] bool fill() const {
        std::ofstream ballast(path("ballast"), std::ios::binary | std::ios::app);
        const std::vector<char> block(1 << 16);
        while (ballast.write(block.data(), static_cast<std::streamsize>(block.size())).flush()) {
        }
        return std::filesystem::space(m_folder).available == 0;
    }
    void empty() const { std::filesystem::remove(path("ballast")); }

private:
    std::string m_folder;
    bool m_exists = false;
};

} // namespace teleta::test
