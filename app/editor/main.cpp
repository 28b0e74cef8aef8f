#include "ui/shell/application.h"

int main(int argc, char** argv)
{
    return fumage::ui::runEditor(argc, argv);
}
