#include "ui/theme/theme.h"

#include "ui/theme/window_frame.h"

#include <QApplication>
#include <QFile>
#include <QStyleFactory>
#include <QtPlugin>

Q_IMPORT_PLUGIN(SvgIconPlugin) // the style sheet's pictures

namespace fumage::ui {

namespace {

constexpr ThemeColours kDark{.window = 0xff23262b,
    .base = 0xff191b1f,
    .raised = 0xff2f333a,
    .edge = 0xff3d424b,
    .control = 0xff858c97,
    .text = 0xffe2e5ea,
    .quiet = 0xff969ca6,
    .accent = 0xff4a9fd8,
    .onAccent = 0xff10141a,
    .mark = 0xffffb454,
    .good = 0xff5fc57f};
constexpr ThemeColours kLight{.window = 0xfff3f4f6,
    .base = 0xffffffff,
    .raised = 0xffe6e8ec,
    .edge = 0xffc4c8d0,
    .control = 0xff757c88,
    .text = 0xff1f2328,
    .quiet = 0xff5d646f,
    .accent = 0xff1f78b8,
    .onAccent = 0xffffffff,
    .mark = 0xff955400,
    .good = 0xff177037};

QPalette makePalette(const ThemeColours& c)
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
    for (const auto role :
        {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText, QPalette::BrightText}) {
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

QString styleSheet(const ThemeColours& c, bool dark)
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
    put("@control", c.control);
    put("@text", c.text);
    put("@quiet", c.quiet);
    put("@onAccent", c.onAccent);
    put("@accent", c.accent);
    put("@mark", c.mark);
    sheet.replace(QLatin1String("@scheme"), dark ? QStringLiteral("dark") : QStringLiteral("light"));
    return sheet;
}

} // namespace

const ThemeColours& themeColours(bool dark)
{
    return dark ? kDark : kLight;
}

bool isDark(const QPalette& palette)
{
    return palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
}

void applyTheme(QApplication& application, Theme theme, bool desktopIsDark)
{
    const bool dark = theme == Theme::Dark || (theme == Theme::System && desktopIsDark);
    const ThemeColours& colours = themeColours(dark);
    QApplication::setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QApplication::setPalette(makePalette(colours));
    application.setStyleSheet(styleSheet(colours, dark));
    setFrames(application, dark);
}

} // namespace fumage::ui
