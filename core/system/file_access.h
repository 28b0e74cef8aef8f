#pragma once

namespace fumage {

/// Who may read a file that is made.
enum class FileAccess {
    Usual, ///< what the umask leaves; that of the file that is replaced
    Private, ///< the user alone
};

} // namespace fumage
