// SPDX-License-Identifier: MIT
// Hands out the files of one folder over HTTP, to this machine only.
#pragma once

#include <memory>
#include <string>

namespace firma::cli {

/// GET and HEAD of regular files below a folder, on 127.0.0.1. A path that ends in '/' means the index.html there; no
/// folder is listed. What lies outside the folder (by "..", by a link) is not there, nor is what a request names with a
/// name that begins with a dot (a link within the folder that has another name does lead to such): 404. A request whose
/// Host is not this machine is refused: 403, so that no page from elsewhere can read anything under a name of its own.
class FileServer {
public:
    /// Opens the port; nothing is answered before run().
    /// @param port  0: any that is free
    /// @throws Failure when the folder or the port cannot be had
    FileServer(const std::string& folder, int port);
    ~FileServer();

    int port() const { return port_; }
    /// Answers until SIGINT, SIGTERM or SIGHUP; those must be held back in all threads: see hold_back_signals().
    void run();

private:
    struct State;
    std::unique_ptr<State> state_;
    int port_ = 0;
};

/// From now on, in this thread and those it starts, the signals that end run() wait for it.
void hold_back_signals();

}  // namespace firma::cli
