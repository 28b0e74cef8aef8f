#include "core/system/descriptor.h"

#include "core/base/windows_api.h"

namespace fumage {

Descriptor::~Descriptor()
{
    if (*this) {
        ::CloseHandle(m_file);
    }
}

SystemFile Descriptor::none()
{
    return INVALID_HANDLE_VALUE;
}

} // namespace fumage
