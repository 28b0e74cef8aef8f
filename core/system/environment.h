#pragma once

#include <filesystem>
#include <string>

namespace fumage {

/// @return a variable of the environment, as UTF-8; empty where there is none
[[nodiscard]] std::string environmentVariable(const char* name);

/// The user's own folder: $HOME; on Windows %USERPROFILE%.
/// @return an absolute folder; empty where the environment names none
[[nodiscard]] std::filesystem::path userHome();

/// Where programs keep what belongs to the user: $XDG_DATA_HOME or ~/.local/share; on Windows %APPDATA%.
/// @return an absolute folder, which need not be there; empty where the environment names none
[[nodiscard]] std::filesystem::path userDataFolder();

/// Puts another folder in its place, for this program and what it starts. Before threads begin, which may look at the
/// environment.
/// @param folder absolute
void setUserDataFolder(const std::filesystem::path& folder);

} // namespace fumage
