// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/backend/core/temporary_folder.h"

#include <arpa/inet.h>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <netinet/in.h>
#include <stdexcept>
#include <stdlib.h>
#include <string>
#include <sys/socket.h>
#include <unistd.h>

namespace teleta::test {

/// A private PostgreSQL server in a temporary folder, with a password, on a free port of this machine. Root
/// starts it as the user postgres, because it does not run as root.
class PostgresServer {
public:
    static constexpr const char* kPassword = "se:cret@1";

    /// Empty where the server is not installed.
    [[nodiscard]] static std::string programs() {
        std::string found;
        std::error_code none;
        for (const auto& version : std::filesystem::directory_iterator("/usr/lib/postgresql", none)) {
            if (std::filesystem::exists(version.path() / "bin" / "initdb"))
                found = (version.path() / "bin").string();
        }
        return found;
    }

    PostgresServer() {
        std::string pattern = (std::filesystem::temp_directory_path() / "teleta-pg-XXXXXX").string();
        if (mkdtemp(pattern.data()) == nullptr)
            throw std::runtime_error("cannot make a temporary folder");
        m_folder = pattern;
        std::ofstream(m_folder + "/password") << kPassword << '\n';
        if (geteuid() == 0 && std::system(("chown -R postgres '" + m_folder + "'").c_str()) != 0)
            throw std::runtime_error("there is no user postgres");
        call("initdb -D '" + m_folder + "/data' -U console -A scram-sha-256 --pwfile='" + m_folder +
             "/password' --no-sync -E UTF8 --locale=C");
        m_port = freePort();
        start();
    }
    ~PostgresServer() {
        try {
            kill();
        } catch (const std::exception&) {
            // It has already been killed.
        }
        std::error_code ignored;
        std::filesystem::remove_all(m_folder, ignored);
    }
    PostgresServer(const PostgresServer&) = delete;
    PostgresServer& operator=(const PostgresServer&) = delete;

    void start() {
        call("pg_ctl -D '" + m_folder + "/data' -w -l '" + m_folder + "/log' -o '-p " +
             std::to_string(m_port) + " -k " + m_folder +
             " -c listen_addresses=127.0.0.1 -c fsync=off' start");
    }

    /// Stops it immediately, as in a crash: connections break and nothing more is written.
    void kill() { call("pg_ctl -D '" + m_folder + "/data' -w -m immediate stop"); }

    [[nodiscard]] int port() const { return m_port; }

    [[nodiscard]] std::string url(const std::string& study,
                                  const std::string& password = "se%3Acret%401") const {
        return urlAt(m_port, study, password);
    }
    /// The same server behind another port of this machine.
    [[nodiscard]] static std::string urlAt(int port, const std::string& study,
                                           const std::string& password = "se%3Acret%401") {
        return "postgresql://console:" + password + "@127.0.0.1:" + std::to_string(port) +
               "/postgres?study=" + study;
    }

    /// Runs a statement independently of the program under test.
    void sql(const std::string& statement) const {
        call("env PGPASSWORD='" + std::string(kPassword) + "' psql -q -h 127.0.0.1 -p " +
             std::to_string(m_port) + " -U console -d postgres -c \"" + statement + "\"");
    }

private:
    void call(const std::string& command) const {
        const std::string user = geteuid() == 0 ? "runuser -u postgres -- " : "";
        const std::string path = "PATH='" + programs() + "':$PATH ";
        const std::string whole =
            "cd /tmp && " + path + user + "env LC_ALL=C " + command + " > '" + m_folder + ".out' 2>&1";
        const int status = std::system(whole.c_str());
        const std::string text = readAll(m_folder + ".out");
        std::filesystem::remove(m_folder + ".out");
        if (status != 0)
            throw std::runtime_error(command + ": " + text);
    }

    static int freePort() {
        const int descriptor = socket(AF_INET, SOCK_STREAM, 0);
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t length = sizeof address;
        const bool bound = bind(descriptor, reinterpret_cast<sockaddr*>(&address), length) == 0 &&
                           getsockname(descriptor, reinterpret_cast<sockaddr*>(&address), &length) == 0;
        close(descriptor);
        if (!bound)
            throw std::runtime_error("there is no free port");
        return ntohs(address.sin_port);
    }

    std::string m_folder;
    int m_port = 0;
};

} // namespace teleta::test
