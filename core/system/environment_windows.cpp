#include "core/system/environment.h"
#include "core/system/path.h"

#include "core/system/system_text.h"
#include "core/base/windows_api.h"

namespace fumage {

std::string environmentVariable(const char* name)
{
    const std::wstring wide = wideFrom(name);
    std::wstring value(::GetEnvironmentVariableW(wide.c_str(), nullptr, 0), L'\0');
    value.resize(::GetEnvironmentVariableW(wide.c_str(), value.data(), static_cast<DWORD>(value.size())));
    return utf8From(value);
}

namespace {

/// @return the folder that a variable of the environment names; empty where it names none, or one that depends on the
/// working folder
std::filesystem::path absoluteFolder(const char* variable)
{
    const std::filesystem::path folder = pathFrom(environmentVariable(variable));
    return folder.is_absolute() ? folder : std::filesystem::path();
}

} // namespace

std::filesystem::path userHome()
{
    return absoluteFolder("USERPROFILE");
}

std::filesystem::path userDataFolder()
{
    return absoluteFolder("APPDATA");
}

void setUserDataFolder(const std::filesystem::path& folder)
{
    ::SetEnvironmentVariableW(L"APPDATA", folder.c_str());
}

} // namespace fumage
