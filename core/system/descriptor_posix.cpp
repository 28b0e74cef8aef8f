#include "core/system/descriptor.h"

#include <unistd.h>

namespace fumage {

Descriptor::~Descriptor()
{
    if (*this) {
        ::close(m_file);
    }
}

SystemFile Descriptor::none()
{
    return -1;
}

} // namespace fumage
