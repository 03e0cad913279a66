// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace teleta::site_program {

/// Tells systemd how the program is (sd_notify): "READY=1", "WATCHDOG=1", "STOPPING=1", "STATUS=...". Does
/// nothing where no service manager has started the program. Thread: any. Source: sd_notify(3).
class ServiceManager {
public:
    ServiceManager();
    void tell(std::string_view message) const;

private:
    std::string m_socket; ///< path, or @ and an abstract name; empty: nobody listens
};

} // namespace teleta::site_program
