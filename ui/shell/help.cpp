#include "ui/shell/help.h"

#include "ui/document/parameter_text.h"
#include "ui/document/text.h"
#include "ui/face/message_box.h"
#include "ui/shell/action_table.h"

#include "core/effect/parameter_table.h"

#include <QCoreApplication>
#include <QDialog>
#include <QIcon>
#include <QLineEdit>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

QString helpText(const char* text)
{
    return QCoreApplication::translate("Help", text);
}

/// A window with a text and a field that finds words in it.
void showText(QWidget* parent, const QString& name, const QString& title, const QString& html)
{
    if (auto* open = parent->findChild<QDialog*>(name)) {
        open->show();
        open->raise();
        return;
    }
    auto* dialog = new QDialog(parent);
    dialog->setObjectName(name);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(title);
    auto* search = new QLineEdit(dialog);
    search->setPlaceholderText(helpText(QT_TRANSLATE_NOOP("Help", "Find")));
    search->setAccessibleName(search->placeholderText());
    auto* text = new QTextBrowser(dialog);
    text->setHtml(html);
    text->setAccessibleName(title);
    auto* layout = new QVBoxLayout(dialog);
    layout->setContentsMargins(12, 12, 12, 12);
    layout->addWidget(search);
    layout->addWidget(text);
    QObject::connect(search, &QLineEdit::textChanged, text, [text](const QString& words) {
        text->moveCursor(QTextCursor::Start);
        text->find(words);
    });
    QObject::connect(search, &QLineEdit::returnPressed, text, [text, search] { text->find(search->text()); });
    constexpr QSize kUsual(720, 640);
    dialog->resize(kUsual);
    dialog->show();
}

} // namespace

QString parameterReference()
{
    QString html;
    std::string_view group;
    for (const Parameter& parameter : parameterTable()) {
        if (parameter.group() != group) {
            group = parameter.group();
            html += QStringLiteral("<h2>%1</h2>").arg(groupLabelOf(group).toHtmlEscaped());
        }
        html += QStringLiteral("<a name=\"%1\"></a>%2").arg(toQString(parameter.key), toolTipOf(parameter));
    }
    return html;
}

QString shortcutSheet()
{
    QString html;
    QString menu;
    for (const ActionSpec& spec : actionSpecs()) {
        const QString heading = plainText(spec.menu);
        if (heading != menu) {
            html += (menu.isEmpty() ? QString() : QStringLiteral("</table>")) + QStringLiteral("<h3>%1</h3><table width=\"100%\" cellpadding=\"3\">").arg(heading.toHtmlEscaped());
            menu = heading;
        }
        QStringList keys;
        for (const QKeySequence& sequence : QKeySequence::listFromString(QLatin1String(spec.keys))) {
            keys += sequence.toString(QKeySequence::NativeText);
        }
        if (!keys.isEmpty()) {
            html += QStringLiteral("<tr><td width=\"60%\">%1</td><td><b>%2</b></td></tr>").arg(plainText(spec.text).toHtmlEscaped(), keys.join(QStringLiteral(", ")).toHtmlEscaped());
        }
    }
    return html + QStringLiteral("</table>");
}

void showReference(QWidget* parent)
{
    showText(parent, QStringLiteral("referenceDialog"), helpText(QT_TRANSLATE_NOOP("Help", "Parameter reference")), parameterReference());
}

void showShortcuts(QWidget* parent)
{
    showText(parent, QStringLiteral("shortcutDialog"), helpText(QT_TRANSLATE_NOOP("Help", "Keyboard shortcuts")), shortcutSheet());
}

void showAbout(QWidget* parent)
{
    MessageBox box(QStringLiteral("aboutBox"), MessageBox::NoIcon, helpText(QT_TRANSLATE_NOOP("Help", "About Fumage")), {}, MessageBox::Ok, parent);
    constexpr int kIcon = 96;
    box.setIconPixmap(QIcon(QStringLiteral(":/icons/fumage.svg")).pixmap(kIcon, kIcon));
    box.setTextFormat(Qt::RichText);
    box.setText(QStringLiteral("<h2>Fumage %1</h2>").arg(QCoreApplication::applicationVersion().toHtmlEscaped()));
    box.explain(helpText(QT_TRANSLATE_NOOP("Help", "An editor for smoke. Free software under the MIT licence.\n\nThe model begins with Lin and Lin, “Smoke Simulation with Perlin Noise”, University of Gävle, 2012. Made with Qt, GLM, Highway, oneTBB, libpng and OpenEXR.")));
    box.exec();
}

} // namespace fumage::ui
