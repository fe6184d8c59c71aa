// SPDX-License-Identifier: MIT
// base/file_aside.h by the functions of Windows. The lock is that nobody else may open the file; the new name is given
// to the open file, so that no other writer comes between.
#define WIN32_LEAN_AND_MEAN
#include <windows.h>

#include <fcntl.h>
#include <io.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <system_error>
#include <vector>

#include "base/file_aside.h"
#include "base/open_file.h"

namespace firma {
namespace {

/// Milliseconds between two tries to open a file that another writer has.
constexpr DWORD kBetweenTries = 5;
/// Milliseconds for which a name is asked for while the file that has it is open: a writer renames before it closes,
/// and a reader may be at it.
constexpr DWORD kWaitForName = 2000;
/// A single write takes no more.
constexpr std::size_t kPiece = std::size_t(1) << 30;

int reason_of(DWORD error) {
    const std::error_condition reason = std::system_category().default_error_condition(int(error));
    return reason.category() == std::generic_category() && reason.value() != 0 ? reason.value() : EIO;
}

/// May also be renamed and removed while it is open.
HANDLE open_alone(const std::string& path, DWORD how) {
    return CreateFileW(wide_path(path).c_str(), GENERIC_WRITE | DELETE, 0, nullptr, how, FILE_ATTRIBUTE_NORMAL,
                       nullptr);
}

/// Gives an open file a name, which another file may have. @return the system's reason, or ERROR_SUCCESS
DWORD rename_open(HANDLE file, FILE_RENAME_INFO& info, DWORD bytes) {
    for (DWORD waited = 0;; waited += kBetweenTries) {
        if (SetFileInformationByHandle(file, FileRenameInfo, &info, bytes)) return ERROR_SUCCESS;
        const DWORD error = GetLastError();
        const bool is_open = error == ERROR_ACCESS_DENIED || error == ERROR_SHARING_VIOLATION;
        if (!is_open || waited >= kWaitForName) return error;
        Sleep(kBetweenTries);
    }
}

/// Takes over the handle. @return -1 when no descriptor is left
int descriptor_of(HANDLE handle) {
    const int descriptor = _open_osfhandle(reinterpret_cast<std::intptr_t>(handle), _O_BINARY);
    if (descriptor < 0) CloseHandle(handle);
    return descriptor;
}

HANDLE handle_of(int descriptor) {
    return reinterpret_cast<HANDLE>(_get_osfhandle(descriptor));
}

}  // namespace

FileAside::~FileAside() {
    if (descriptor_ < 0) return;
    _close(descriptor_);
    if (!renamed_) DeleteFileW(wide_path(path_).c_str());
}

int FileAside::open_locked() {
    for (;;) {
        const HANDLE handle = open_alone(path_, CREATE_ALWAYS);
        if (handle != INVALID_HANDLE_VALUE) {
            descriptor_ = descriptor_of(handle);
            return descriptor_ < 0 ? EMFILE : 0;
        }
        const DWORD error = GetLastError();
        if (error != ERROR_SHARING_VIOLATION) return reason_of(error);
        Sleep(kBetweenTries);
    }
}

int FileAside::open_new() {
    const HANDLE handle = open_alone(path_, CREATE_NEW);
    if (handle == INVALID_HANDLE_VALUE) return reason_of(GetLastError());
    descriptor_ = descriptor_of(handle);
    return descriptor_ < 0 ? EMFILE : 0;
}

/// Windows keeps permissions with the folder.
void FileAside::set_mode(mode_t) {}

int FileAside::write(std::span<const std::byte> bytes) {
    return write_all(descriptor_, bytes);
}

int FileAside::flush() {
    return FlushFileBuffers(handle_of(descriptor_)) ? 0 : reason_of(GetLastError());
}

int FileAside::rename_to(const std::string& target) {
    std::error_code failed;
    const std::wstring name = std::filesystem::absolute(wide_path(target), failed).make_preferred().wstring();
    if (failed) return EINVAL;
    const std::size_t bytes = name.size() * sizeof(wchar_t);
    std::vector<std::uint64_t> memory((sizeof(FILE_RENAME_INFO) + bytes) / sizeof(std::uint64_t) + 1);
    auto* info = reinterpret_cast<FILE_RENAME_INFO*>(memory.data());
    info->ReplaceIfExists = TRUE;
    info->FileNameLength = DWORD(bytes);
    std::copy(name.begin(), name.end(), info->FileName);
    const DWORD error = rename_open(handle_of(descriptor_), *info, DWORD(memory.size() * sizeof(std::uint64_t)));
    renamed_ = error == ERROR_SUCCESS;
    return renamed_ ? 0 : reason_of(error);
}

int write_all(int descriptor, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const int count = _write(descriptor, bytes.data(), unsigned(std::min(bytes.size(), kPiece)));
        if (count < 0) return errno;
        bytes = bytes.subspan(std::size_t(count));
    }
    return 0;
}

int resolve_links(std::string& path) {
    std::error_code failed;
    const std::filesystem::path given = wide_path(path);
    if (!std::filesystem::is_symlink(given, failed)) return 0;
    const std::filesystem::path real = std::filesystem::canonical(given, failed);
    if (failed) return ENOENT;
    const std::u8string text = real.u8string();
    path.assign(text.begin(), text.end());
    return 0;
}

int write_whole_file(const std::string& path, const std::function<int(FileAside&)>& write) {
    std::string target = path;
    if (const int reason = resolve_links(target)) return reason;
    const DWORD there = GetFileAttributesW(wide_path(target).c_str());
    if (there != INVALID_FILE_ATTRIBUTES) {
        if (there & FILE_ATTRIBUTE_DIRECTORY) return EISDIR;
        if (there & FILE_ATTRIBUTE_READONLY) return EACCES;
    }
    FileAside aside(target + ".part");
    if (const int reason = aside.open_locked()) return reason;
    if (const int reason = write(aside)) return reason;
    if (const int reason = aside.flush()) return reason;
    return aside.rename_to(target);
}

}  // namespace firma
