#include "ui/shell/help.h"

#include "ui/document/parameter_text.h"
#include "ui/document/text.h"
#include "ui/help/manual_window.h"
#include "ui/theme/icons.h"
#include "ui/widgets/message_box.h"
#include "ui/shell/action_table.h"
#include "ui/shell/settings.h"

#include "core/effect/shown_table.h"

#include <algorithm>
#include <utility>

#include <QApplication>
#include <QCoreApplication>
#include <QCursor>
#include <QDialog>
#include <QIcon>
#include <QLabel>
#include <QLineEdit>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

QString helpText(const char* text)
{
    return QCoreApplication::translate("Help", text);
}

QLabel* makeNote(const QString& text, QWidget* parent)
{
    auto* note = new QLabel(text, parent);
    note->setObjectName(QStringLiteral("referenceNote"));
    note->setTextFormat(Qt::PlainText);
    note->setWordWrap(true);
    return note;
}

/// A window with a text and a field that finds words in it.
/// @param anchor in the text, where it begins; empty: at the top, or where it was
/// @param note   said above it; empty: nothing
void showText(QWidget* parent, const QString& name, const QString& title, const QString& html,
    const QString& anchor = {}, const QString& note = {})
{
    if (auto* open = parent->findChild<QDialog*>(name)) {
        open->show();
        open->raise();
        open->findChild<QTextBrowser*>()->scrollToAnchor(anchor);
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
    if (!note.isEmpty()) {
        layout->addWidget(makeNote(note, dialog));
    }
    layout->addWidget(text);
    QObject::connect(search, &QLineEdit::textChanged, text, [text](const QString& words) {
        text->moveCursor(QTextCursor::Start);
        text->find(words);
    });
    QObject::connect(search, &QLineEdit::returnPressed, text, [text, search] { text->find(search->text()); });
    constexpr QSize kUsual(720, 640);
    dialog->resize(kUsual);
    dialog->show();
    text->scrollToAnchor(anchor);
}

/// The keys of an action, in the words of the system.
QString keysOf(const ActionSpec& spec)
{
    QStringList keys;
    for (const QKeySequence& sequence : QKeySequence::listFromString(QLatin1String(spec.keys))) {
        keys += sequence.toString(QKeySequence::NativeText);
    }
    return keys.join(QStringLiteral(", "));
}

/// The key of a parameter in the name of one of its widgets, as "essentials.look.size.label"; empty: it is no
/// parameter's.
QString parameterIn(const QString& name)
{
    const QStringList parts = name.split(QLatin1Char('.'));
    for (qsizetype i = 0; i + 1 < parts.size(); ++i) {
        QString key = parts[i] + QLatin1Char('.') + parts[i + 1];
        if (findShownParameter(key.toStdString()) != nullptr) {
            return key;
        }
    }
    return {};
}

/// The name of a group in the name of its heading or its box.
QString groupIn(const QString& name)
{
    const QStringList parts = name.split(QLatin1Char('.'));
    const std::string group =
        parts.size() > 1 && parts[0] == QLatin1String("group") ? parts[1].toStdString() : std::string();
    const auto& shown = shownParameters();
    const bool isGroup =
        std::any_of(shown.begin(), shown.end(), [&](const Parameter* each) { return each->group() == group; });
    return isGroup ? parts[1] : QString();
}

} // namespace

QString parameterReference()
{
    QString html;
    std::string_view group;
    for (const Parameter* shown : shownParameters()) {
        const Parameter& parameter = *shown;
        if (parameter.group() != group) {
            group = parameter.group();
            html += QStringLiteral("<a name=\"%1\"></a><h2>%2</h2>")
                        .arg(toQString(group), groupLabelOf(group).toHtmlEscaped());
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
            html += (menu.isEmpty() ? QString() : QStringLiteral("</table>"))
                + QStringLiteral("<h3>%1</h3><table width=\"100%\" cellpadding=\"3\">").arg(heading.toHtmlEscaped());
            menu = heading;
        }
        const QString keys = keysOf(spec);
        if (!keys.isEmpty()) {
            html += QStringLiteral("<tr><td width=\"60%\">%1</td><td><b>%2</b></td></tr>")
                        .arg(plainText(spec.text).toHtmlEscaped(), keys.toHtmlEscaped());
        }
    }
    return html + QStringLiteral("</table>");
}

QString shortcutLines()
{
    QString lines;
    for (const ActionSpec& spec : actionSpecs()) {
        const QString keys = keysOf(spec);
        if (!keys.isEmpty()) {
            lines += keys + QLatin1Char('\t') + plainText(spec.text) + QLatin1Char('\n');
        }
    }
    return lines;
}

QString referenceAnchorAt(const QWidget* widget)
{
    for (; widget != nullptr; widget = widget->parentWidget()) {
        const QString key = parameterIn(widget->objectName());
        QString anchor = key.isEmpty() ? groupIn(widget->objectName()) : key;
        if (!anchor.isEmpty()) {
            return anchor;
        }
    }
    return {};
}

QString referenceAnchorAtHand()
{
    const QString underMouse = referenceAnchorAt(QApplication::widgetAt(QCursor::pos()));
    return underMouse.isEmpty() ? referenceAnchorAt(QApplication::focusWidget()) : underMouse;
}

void showReference(QWidget* parent, const QString& anchor, const QString& note)
{
    showText(parent, QStringLiteral("referenceDialog"), helpText(QT_TRANSLATE_NOOP("Help", "Parameter reference")),
        parameterReference(), anchor, note);
}

void showManual(QWidget* parent, Settings& settings, const ManualFolders& folders, const QString& anchor)
{
    auto* window = parent->findChild<ManualWindow*>();
    if (window == nullptr) {
        Manual manual(folders);
        if (!manual.problem().isEmpty()) {
            showReference(parent, anchor,
                helpText(QT_TRANSLATE_NOOP("Help", "%1 These are the tips of all parameters.")).arg(manual.problem()));
            return;
        }
        static const QString kGeometry = QStringLiteral("manual/geometry");
        window = new ManualWindow(std::move(manual), parent);
        window->setAttribute(Qt::WA_DeleteOnClose);
        window->restoreGeometry(settings.bytes(kGeometry));
        QObject::connect(window, &QDialog::finished, window,
            [window, &settings] { settings.setBytes(kGeometry, window->saveGeometry()); });
    }
    window->show();
    window->raise();
    window->activateWindow();
    window->showAt(anchor);
}

void showShortcuts(QWidget* parent)
{
    showText(parent, QStringLiteral("shortcutDialog"), helpText(QT_TRANSLATE_NOOP("Help", "Keyboard shortcuts")),
        shortcutSheet());
}

void showAbout(QWidget* parent)
{
    MessageBox box(QStringLiteral("aboutBox"), MessageBox::NoIcon, helpText(QT_TRANSLATE_NOOP("Help", "About Fumage")),
        {}, MessageBox::Ok, parent);
    constexpr int kIcon = 96;
    box.setIconPixmap(themedIcon(QStringLiteral("fumage")).pixmap(kIcon, kIcon));
    box.setTextFormat(Qt::RichText);
    box.setText(QStringLiteral("<h2>Fumage %1</h2>").arg(QCoreApplication::applicationVersion().toHtmlEscaped()));
    box.explain(helpText(QT_TRANSLATE_NOOP("Help",
        "An editor for smoke. Free software under the MIT licence.\n\nThe model begins with Lin and Lin, “Smoke "
        "Simulation with Perlin Noise”, University of Gävle, 2012. Made with Qt, GLM, Highway, oneTBB, libpng and "
        "OpenEXR.")));
    box.exec();
}

} // namespace fumage::ui
