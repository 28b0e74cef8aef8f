#include "core/system/path.h"

#include "core/system/system_text.h"

namespace fumage {

std::filesystem::path pathFrom(std::string_view utf8)
{
    return wideFrom(utf8);
}

} // namespace fumage
