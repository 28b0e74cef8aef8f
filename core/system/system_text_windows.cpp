#include "core/system/system_text.h"

#include "core/base/text.h"
#include "core/base/windows_api.h"

#include <array>

namespace fumage {

std::string utf8From(std::wstring_view text)
{
    const int length = static_cast<int>(text.size());
    std::string out(
        static_cast<std::size_t>(::WideCharToMultiByte(CP_UTF8, 0, text.data(), length, nullptr, 0, nullptr, nullptr)),
        '\0');
    ::WideCharToMultiByte(CP_UTF8, 0, text.data(), length, out.data(), static_cast<int>(out.size()), nullptr, nullptr);
    return out;
}

std::wstring wideFrom(std::string_view utf8)
{
    const int length = static_cast<int>(utf8.size());
    std::wstring out(
        static_cast<std::size_t>(::MultiByteToWideChar(CP_UTF8, 0, utf8.data(), length, nullptr, 0)), L'\0');
    ::MultiByteToWideChar(CP_UTF8, 0, utf8.data(), length, out.data(), static_cast<int>(out.size()));
    return out;
}

std::string systemText(unsigned long error)
{
    std::array<wchar_t, 512> buffer{};
    const DWORD length = ::FormatMessageW(FORMAT_MESSAGE_FROM_SYSTEM | FORMAT_MESSAGE_IGNORE_INSERTS, nullptr, error, 0,
        buffer.data(), static_cast<DWORD>(buffer.size()), nullptr);
    const std::string text = utf8From({buffer.data(), length});
    return length > 0 ? std::string(trimmed(text)) : "Windows error " + std::to_string(error);
}

} // namespace fumage
