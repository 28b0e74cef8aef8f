#include "ui/theme/icons.h"

#include "ui/theme/svg_icon.h"
#include "ui/widgets/plain_text.h"

#include <QToolButton>

namespace fumage::ui {

QIcon themedIcon(const QString& name)
{
    return QIcon(makeSvgIconEngine(QStringLiteral(":/icons/%1.svg").arg(name)));
}

QToolButton* makeIconButton(QWidget* parent, const QString& name, const QString& icon, const QString& tip)
{
    auto* button = new QToolButton(parent);
    button->setObjectName(name);
    button->setAccessibleName(tip);
    button->setToolTip(plainToolTip(tip));
    button->setIcon(themedIcon(icon));
    button->setAutoRaise(true);
    return button;
}

} // namespace fumage::ui
