#include "core/system/path.h"

namespace fumage {

std::filesystem::path pathFrom(std::string_view utf8)
{
    return utf8;
}

} // namespace fumage
