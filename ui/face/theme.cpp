#include "ui/face/theme.h"

#include <QApplication>
#include <QFile>
#include <QStyleFactory>

namespace fumage::ui {

namespace {

/// The colours of a theme, by what they are for.
struct Colours {
    QRgb window;
    QRgb base; ///< behind fields and lists
    QRgb raised; ///< buttons, headings
    QRgb edge;
    QRgb text;
    QRgb quiet; ///< text that stands back
    QRgb accent;
    QRgb onAccent;
    QRgb mark; ///< what differs from the preset
};

constexpr Colours kDark{0xff23262b, 0xff191b1f, 0xff2f333a, 0xff3d424b, 0xffe2e5ea, 0xff969ca6, 0xff4a9fd8, 0xffffffff, 0xffffb454};
constexpr Colours kLight{0xfff3f4f6, 0xffffffff, 0xffe6e8ec, 0xffc4c8d0, 0xff1f2328, 0xff666d78, 0xff1f78b8, 0xffffffff, 0xffb56a00};

QPalette makePalette(const Colours& c)
{
    QPalette palette;
    palette.setColor(QPalette::Window, c.window);
    palette.setColor(QPalette::Base, c.base);
    palette.setColor(QPalette::AlternateBase, c.raised);
    palette.setColor(QPalette::Button, c.raised);
    palette.setColor(QPalette::Mid, c.edge);
    palette.setColor(QPalette::Midlight, c.edge);
    palette.setColor(QPalette::Dark, c.edge);
    palette.setColor(QPalette::Light, c.raised);
    palette.setColor(QPalette::Shadow, QColor(0, 0, 0, 120));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText, QPalette::BrightText}) {
        palette.setColor(role, c.text);
        palette.setColor(QPalette::Disabled, role, c.quiet);
    }
    palette.setColor(QPalette::PlaceholderText, c.quiet);
    palette.setColor(QPalette::ToolTipBase, c.raised);
    palette.setColor(QPalette::Highlight, c.accent);
    palette.setColor(QPalette::HighlightedText, c.onAccent);
    palette.setColor(QPalette::Link, c.accent);
    return palette;
}

QString styleSheet(const Colours& c)
{
    QFile file(QStringLiteral(":/theme/fumage.qss"));
    if (!file.open(QIODevice::ReadOnly)) {
        return {};
    }
    QString sheet = QString::fromUtf8(file.readAll());
    const auto put = [&](const char* name, QRgb colour) { sheet.replace(QLatin1String(name), QColor(colour).name()); };
    put("@window", c.window);
    put("@base", c.base);
    put("@raised", c.raised);
    put("@edge", c.edge);
    put("@text", c.text);
    put("@quiet", c.quiet);
    put("@onAccent", c.onAccent);
    put("@accent", c.accent);
    put("@mark", c.mark);
    return sheet;
}

} // namespace

bool isDark(const QPalette& palette)
{
    return palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
}

void applyTheme(QApplication& application, Theme theme, bool desktopIsDark)
{
    const bool dark = theme == Theme::Dark || (theme == Theme::System && desktopIsDark);
    const Colours& colours = dark ? kDark : kLight;
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QApplication::setPalette(makePalette(colours));
    application.setStyleSheet(styleSheet(colours));
}

} // namespace fumage::ui
