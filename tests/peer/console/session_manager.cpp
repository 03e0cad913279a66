// SPDX-License-Identifier: GPL-3.0-or-later
// A session manager by libSM, that of X11's desktops, for one program at a time.
// It says "ready ADDRESS" first, ADDRESS being what the program finds in SESSION_MANAGER, and "joined" when a
// program has registered. On its standard input it takes "end": the program is asked to save, for a shutdown,
// and then to die; "saved" and "gone" follow.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <poll.h>
#include <unistd.h>
#include <vector>
#include <X11/ICE/ICElib.h>
#include <X11/ICE/ICEutil.h>
#include <X11/SM/SMlib.h>

namespace {

SmsConn g_program = nullptr;
bool g_ends = false;

void say(const char* word) {
    std::printf("%s\n", word);
    std::fflush(stdout);
}

int onRegister(SmsConn connection, SmPointer, char* previous) {
    if (previous != nullptr) {
        std::free(previous);
        return 0; // no session is restored here
    }
    char* id = SmsGenerateClientID(connection);
    SmsRegisterClientReply(connection, id);
    std::free(id);
    // The protocol asks for this after every registration.
    SmsSaveYourself(connection, SmSaveLocal, False, SmInteractStyleNone, False);
    g_program = connection;
    return 1;
}

void onSaved(SmsConn connection, SmPointer, int) {
    if (!g_ends) {
        SmsSaveComplete(connection);
        say("joined");
        return;
    }
    say("saved");
    SmsDie(connection);
}

void onClosed(SmsConn connection, SmPointer, int, char**) {
    SmsCleanUp(connection);
    g_program = nullptr;
    if (g_ends)
        say("gone");
}

void onPhase2(SmsConn connection, SmPointer) {
    SmsSaveYourselfPhase2(connection);
}

void onProperties(SmsConn, SmPointer, int count, SmProp** properties) {
    for (int i = 0; i < count; ++i)
        SmFreeProperty(properties[i]);
    std::free(properties);
}

int onNewProgram(SmsConn, SmPointer, unsigned long* mask, SmsCallbacks* calls, char**) {
    *calls = {};
    calls->register_client.callback = onRegister;
    calls->interact_request.callback = [](SmsConn connection, SmPointer, int) { SmsInteract(connection); };
    calls->interact_done.callback = [](SmsConn, SmPointer, int) {};
    calls->save_yourself_request.callback = [](SmsConn, SmPointer, int, int, int, int, int) {};
    calls->save_yourself_phase2_request.callback = onPhase2;
    calls->save_yourself_done.callback = onSaved;
    calls->close_connection.callback = onClosed;
    calls->set_properties.callback = onProperties;
    calls->delete_properties.callback = [](SmsConn, SmPointer, int, char**) {};
    calls->get_properties.callback = [](SmsConn connection, SmPointer) {
        SmsReturnProperties(connection, 0, nullptr);
    };
    *mask = SmsRegisterClientProcMask | SmsInteractRequestProcMask | SmsInteractDoneProcMask |
            SmsSaveYourselfRequestProcMask | SmsSaveYourselfP2RequestProcMask | SmsSaveYourselfDoneProcMask |
            SmsCloseConnectionProcMask | SmsSetPropertiesProcMask | SmsDeletePropertiesProcMask |
            SmsGetPropertiesProcMask;
    return 1;
}

} // namespace

int main() {
    char problem[256] = "";
    const auto everybody = [](char*) { return 1; };
    if (SmsInitialize("test", "1", onNewProgram, nullptr, everybody, sizeof problem, problem) == 0) {
        std::fprintf(stderr, "SmsInitialize: %s\n", problem);
        return EXIT_FAILURE;
    }
    IceSetIOErrorHandler([](IceConn) {}); // a program that is killed does not end this one
    int doors = 0;
    IceListenObj* listening = nullptr;
    if (IceListenForConnections(&doors, &listening, sizeof problem, problem) == 0) {
        std::fprintf(stderr, "IceListenForConnections: %s\n", problem);
        return EXIT_FAILURE;
    }
    for (int i = 0; i < doors; ++i)
        IceSetHostBasedAuthProc(listening[i], everybody);
    std::printf("ready %s\n", IceComposeNetworkIdList(doors, listening));
    std::fflush(stdout);

    std::vector<IceConn> connections;
    for (;;) {
        std::vector<pollfd> waiting{{STDIN_FILENO, POLLIN, 0}};
        for (int i = 0; i < doors; ++i)
            waiting.push_back({IceGetListenConnectionNumber(listening[i]), POLLIN, 0});
        const std::size_t first = waiting.size();
        for (IceConn connection : connections)
            waiting.push_back({IceConnectionNumber(connection), POLLIN, 0});
        if (poll(waiting.data(), waiting.size(), -1) < 0)
            return EXIT_FAILURE;
        if (waiting[0].revents != 0) {
            char line[64] = "";
            if (std::fgets(line, sizeof line, stdin) == nullptr)
                return EXIT_SUCCESS;
            if (std::strncmp(line, "end", 3) == 0 && g_program != nullptr) {
                g_ends = true;
                SmsSaveYourself(g_program, SmSaveBoth, True, SmInteractStyleAny, False);
            }
        }
        for (std::size_t i = first; i < waiting.size(); ++i) {
            IceConn& connection = connections[i - first];
            if (waiting[i].revents != 0 &&
                IceProcessMessages(connection, nullptr, nullptr) != IceProcessMessagesSuccess)
                connection = nullptr;
        }
        std::erase(connections, nullptr);
        for (int i = 0; i < doors; ++i) {
            if (waiting[1 + static_cast<std::size_t>(i)].revents == 0)
                continue;
            IceAcceptStatus status{};
            if (IceConn connection = IceAcceptConnection(listening[i], &status))
                connections.push_back(connection);
        }
    }
}
