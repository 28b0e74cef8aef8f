// What *_windows.cpp of the core promise:  platform_checks FOLDER
// A program of its own, also as the other program that holds, writes, reads and fails:  platform_checks
// hold|copy|fail|sleep ...

#include "core/base/aligned_array.h"
#include "core/system/child_process.h"
#include "core/system/environment.h"
#include "core/system/file.h"
#include "core/system/file_draft.h"
#include "core/system/file_lock.h"
#include "core/base/parallel.h"
#include "core/system/path.h"
#include "core/system/system_text.h"
#include "core/base/windows_api.h"

#include <array>
#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <iterator>
#include <thread>

#include <fcntl.h>
#include <io.h>
#include <psapi.h>
#include <shellapi.h>

using namespace fumage;

namespace {

int s_failed = 0;

void check(bool holds, const char* what)
{
    std::printf("%s  %s\n", holds ? "good  " : "FAILED", what);
    std::fflush(stdout);
    s_failed += holds ? 0 : 1;
}

std::string contents(const std::filesystem::path& file)
{
    const Result<std::string> text = readFile(file, 1U << 20U);
    return text ? text.value() : text.error().text();
}

bool says(const Status& status, ErrorCode code, std::string_view text)
{
    const bool isSo = !status && status.error().code == code && status.error().text().find(text) != std::string::npos;
    if (!isSo) {
        std::printf("        %s\n", status ? "it succeeded" : status.error().text().c_str());
    }
    return isSo;
}

std::size_t filesIn(const std::filesystem::path& folder)
{
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(folder), std::filesystem::directory_iterator()));
}

/// This program as another one.
ChildProcess other(const std::vector<std::string>& arguments)
{
    std::array<wchar_t, 1024> name{};
    const DWORD length = ::GetModuleFileNameW(nullptr, name.data(), static_cast<DWORD>(name.size()));
    return std::move(ChildProcess::start(utf8From({name.data(), length}), arguments).value());
}

void paths()
{
    check(pathFrom("r\xc3\xb6k \xe7\x83\x9f \xf0\x9f\x94\xa5.txt")
            == std::filesystem::path(L"r\u00f6k \u70df \U0001F525.txt"),
        "a path has the letters of its text");
    check(pathFrom("a\xff.txt") == std::filesystem::path(L"a\ufffd.txt") && pathFrom("").empty(),
        "and U+FFFD for what is none");
}

void files(const std::filesystem::path& folder)
{
    const std::filesystem::path file =
        folder / std::filesystem::path(u8"smoke \u70df \u00e5\u00e4\u00f6 \U0001F525.txt");
    check(writeFileAtomically(file, std::string_view("one\n")).ok() && contents(file) == "one\n",
        "a file with letters of many scripts is written and read");
    check(writeFileAtomically(file, std::string_view("two\r\n\x1a")).ok() && contents(file) == "two\r\n\x1a",
        "it is replaced, byte for byte");
    check(filesIn(folder) == 1, "nothing else is left in the folder");
    check(readFileHead(file, 2).value() == "tw", "the beginning of a file is read");
    check(says(writeFileAtomically(folder, std::string_view("x")), ErrorCode::NotAFile, "it is a folder"),
        "a folder is not replaced");
    check(says(writeFileAtomically(folder / "none" / "a.txt", std::string_view("x")), ErrorCode::FileNotFound, "none"),
        "a folder that is missing is named");
    check(says(writeFileAtomically("NUL", std::string_view("x")), ErrorCode::NotAFile, "NUL"), "a device is no file");
    ::SetFileAttributesW(file.c_str(), FILE_ATTRIBUTE_READONLY);
    check(says(writeFileAtomically(file, std::string_view("x")), ErrorCode::PermissionDenied, "permission denied"),
        "a file that may not be written is not replaced");
    ::SetFileAttributesW(file.c_str(), FILE_ATTRIBUTE_NORMAL);
    check(contents(file) == "two\r\n\x1a", "and keeps what it holds");
    {
        const Descriptor reader(::CreateFileW(file.c_str(), GENERIC_READ,
            FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, nullptr, OPEN_EXISTING, 0, nullptr));
        std::array<char, 8> old{};
        DWORD count = 0;
        const bool isReplaced = writeFileAtomically(file, std::string_view("three")).ok();
        ::ReadFile(reader.get(), old.data(), static_cast<DWORD>(old.size()), &count, nullptr);
        check(!isReplaced || std::string_view(old.data(), count) == "two\r\n\x1a",
            "who reads a file reads what it was when it was opened");
    }
    {
        const Descriptor holder(::CreateFileW(file.c_str(), GENERIC_READ, 0, nullptr, OPEN_EXISTING, 0, nullptr));
        check(says(writeFileAtomically(file, std::string_view("x")), ErrorCode::PermissionDenied, ""),
            "a file that another program holds is not replaced");
        check(filesIn(folder) == 1, "and nothing is left of the attempt");
    }
    check(writeFileAtomically(file, std::string_view("mine"), FileAccess::Private).ok() && contents(file) == "mine",
        "a private file is written");
    check(writeFileAtomically(file, std::string_view("again")).ok() && contents(file) == "again",
        "and can be replaced by its owner");
    const std::vector<std::byte> bytes(3, std::byte{'x'});
    const std::array<FileContents, 2> pair{FileContents{folder / "a", bytes}, FileContents{folder / "b", bytes}};
    check(writeTogetherAtomically(pair).ok() && contents(folder / "a") == "xxx" && contents(folder / "b") == "xxx",
        "two files are written together");
    check(writeTogetherAtomically(pair).ok(), "and again: their lock was given back");
}

/// Until the other program has begun.
void waitFor(const std::filesystem::path& file)
{
    while (!std::filesystem::exists(file)) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
}

void locks(const std::filesystem::path& folder)
{
    const std::filesystem::path lock = folder / "lock";
    const std::filesystem::path begun = folder / "begun";
    {
        const ChildProcess holder = other({"hold", folder.string()});
        waitFor(begun);
        check(FileLock::tryTake(lock) == nullptr, "a lock that another program holds is not had");
        std::size_t before = filesIn(folder);
        clearLeftovers(folder);
        check(filesIn(folder) == before, "the draft of a living program stays");
    }
    // The other was ended where it was.
    const std::unique_ptr<FileLock> mine = FileLock::tryTake(lock);
    check(mine != nullptr, "what a killed program held can be had");
    check(FileLock::tryTake(lock) == nullptr, "but only once");
    clearLeftovers(folder);
    std::filesystem::remove(begun);
    check(filesIn(folder) == 1, "its draft is cleared away");
}

int hold(const std::filesystem::path& folder)
{
    const std::unique_ptr<FileLock> lock = FileLock::tryTake(folder / "lock");
    const Result<FileDraft> draft =
        FileDraft::make(folder / "draft.txt", {}, FileAccess::Usual, FileDraft::Naming::Temporary);
    std::ofstream(folder / "begun") << "yes";
    ::Sleep(lock && draft ? INFINITE : 0);
    return 1;
}

void children(const std::filesystem::path& folder)
{
    const std::string words = "a \"b\\\" \\\\ c\\ \xe7\x83\x9f";
    const std::filesystem::path file = folder / "copied";
    const std::vector<std::byte> bytes(5'000'000, std::byte{0x1a});
    ChildProcess copier = other({"copy", file.string(), words, ""});
    check(copier.write(bytes).ok() && copier.finish().ok(), "a program takes five megabytes");
    check(std::filesystem::file_size(file) == bytes.size() + words.size() + 1,
        "and has them all, and its arguments as they were given");
    ChildProcess failing = other({"fail"});
    static_cast<void>(failing.write(bytes));
    check(says(failing.finish(), ErrorCode::WriteFailed, "it does not like this"),
        "the last words of one that fails are heard");
    ChildProcess sleeping = other({"sleep"});
    std::stop_source stop;
    std::jthread later([&] { stop.request_stop(); });
    check(says(sleeping.write(bytes, stop.get_token()), ErrorCode::Cancelled, ""),
        "waiting for one that takes nothing can be cancelled");
    const Result<ChildProcess> missing = ChildProcess::start("no-such-program", {});
    check(!missing && missing.error().code == ErrorCode::FileNotFound, "a program that is missing is said to be");
}

std::size_t privateBytes()
{
    PROCESS_MEMORY_COUNTERS counters{};
    ::GetProcessMemoryInfo(::GetCurrentProcess(), &counters, sizeof(counters));
    return counters.WorkingSetSize;
}

void memory()
{
    constexpr std::size_t kBytes = std::size_t{64} << 20U;
    const std::size_t before = privateBytes();
    {
        AlignedArray<float> array(kBytes / sizeof(float), 1.0F);
        check(reinterpret_cast<std::uintptr_t>(array.data()) % kAlignment == 0, "large arrays are aligned");
        check(privateBytes() >= before + kBytes / 2, "their memory is used");
    }
    check(privateBytes() < before + kBytes / 2, "and goes back to the system");
    bool isRefused = false;
    try {
        const AlignedArray<float> array(std::size_t{1} << 50U);
    } catch (const std::bad_alloc&) {
        isRefused = true;
    }
    check(isRefused, "more than there is is refused");
}

void threads()
{
    computeInBackground();
    std::atomic<int> lowered = 0;
    std::atomic<int> asked = 0;
    const std::thread::id first = std::this_thread::get_id();
    parallelFor(64, [&](std::size_t) {
        const bool isFirst = std::this_thread::get_id() == first;
        const int priority = ::GetThreadPriority(::GetCurrentThread());
        lowered += (isFirst ? priority == THREAD_PRIORITY_NORMAL : priority == THREAD_PRIORITY_BELOW_NORMAL) ? 1 : 0;
        ++asked;
        ::Sleep(1);
    });
    check(lowered == asked, "threads in the background give way, the first does not");
}

} // namespace

int main(int argc, char** argv)
{
    int count = 0;
    wchar_t** const wide = ::CommandLineToArgvW(::GetCommandLineW(), &count);
    std::vector<std::string> words(1);
    for (int i = 1; i < count; ++i) {
        words.push_back(utf8From(wide[i]));
    }
    static_cast<void>(argc);
    static_cast<void>(argv);
    const std::string& kind = words.at(1);
    if (kind == "hold") {
        return hold(wideFrom(words.at(2)));
    }
    if (kind == "copy") {
        _setmode(_fileno(stdin), _O_BINARY);
        std::ofstream file(std::filesystem::path(wideFrom(words.at(2))), std::ios::binary);
        file << words.at(3) << words.size() - 4 << std::cin.rdbuf();
        return 0;
    }
    if (kind == "fail") {
        std::fprintf(stderr, "it does not like this\n");
        return 3;
    }
    if (kind == "sleep") {
        ::Sleep(INFINITE);
    }
    const std::filesystem::path folder = std::filesystem::path(wideFrom(kind)) / std::filesystem::path(u8"t\u00e9st");
    std::filesystem::remove_all(folder);
    for (const auto& [name, test] : {std::pair{"files", &files}, {"locks", &locks}, {"children", &children}}) {
        std::filesystem::create_directories(folder / name);
        test(folder / name);
    }
    paths();
    memory();
    threads();
    check(userDataFolder().is_absolute(), "the user's folder is known");
    const std::filesystem::path before = userDataFolder();
    const std::filesystem::path other = before / pathFrom("r\xC3\xB6k \xE7\x83\x9F");
    setUserDataFolder(other);
    check(userDataFolder() == other, "and may be another");
    setUserDataFolder(before);
    std::filesystem::remove_all(folder);
    return s_failed == 0 ? 0 : 1;
}
