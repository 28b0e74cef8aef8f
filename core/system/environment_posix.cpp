#include "core/system/environment.h"
#include "core/system/path.h"

#include <cstdlib>

#include <stdlib.h>

namespace fumage {

namespace {

/// @return the folder that a variable of the environment names; empty where it names none, or one that depends on the
/// working folder
std::filesystem::path absoluteFolder(const char* variable)
{
    const std::filesystem::path folder = pathFrom(environmentVariable(variable));
    return folder.is_absolute() ? folder : std::filesystem::path();
}

} // namespace

std::string environmentVariable(const char* name)
{
    const char* value = std::getenv(name);
    return value == nullptr ? std::string() : value;
}

std::filesystem::path userHome()
{
    return absoluteFolder("HOME");
}

std::filesystem::path userDataFolder()
{
    const std::filesystem::path base = absoluteFolder("XDG_DATA_HOME");
    const std::filesystem::path home = userHome();
    return !base.empty() || home.empty() ? base : home / ".local" / "share";
}

void setUserDataFolder(const std::filesystem::path& folder)
{
    ::setenv("XDG_DATA_HOME", folder.c_str(), 1); // NOLINT(concurrency-mt-unsafe): as the header says
}

} // namespace fumage
