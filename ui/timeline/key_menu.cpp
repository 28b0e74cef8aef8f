#include "ui/timeline/key_menu.h"

#include "ui/timeline/ease_icon.h"
#include "ui/timeline/key_clipboard.h"
#include "ui/timeline/key_mends.h"
#include "ui/timeline/key_selection.h"
#include "ui/timeline/key_table_menu.h"

#include <QCoreApplication>
#include <QMenu>

#include <array>
#include <functional>

namespace fumage::ui {

namespace {

struct KeyMenu {
    Q_DECLARE_TR_FUNCTIONS(KeyMenu)
};

void addEases(QMenu& menu, Document& document, const KeySelection& selection)
{
    const QColor colour = menu.palette().text().color();
    const auto add = [&](const QIcon& icon, const QString& text, const std::function<void()>& choose) {
        QAction* action = menu.addAction(icon, text, &selection, choose);
        action->setEnabled(!selection.keys().empty());
        action->setIconVisibleInMenu(true);
    };
    const std::array names{KeyMenu::tr("Smooth"), KeyMenu::tr("Linear"), KeyMenu::tr("Hold"), KeyMenu::tr("Free")};
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto ease = static_cast<Ease>(i);
        add(easeIcon(ease, colour), names[i],
            [&document, &selection, ease] { setEase(document, selection.keys(), ease); });
    }
    menu.addSeparator();
    const auto addLevel = [&](const QString& text, bool in, bool out) {
        add(levelIcon(in, out, colour), text,
            [&document, &selection, in, out] { setLevel(document, selection.keys(), in, out); });
    };
    addLevel(KeyMenu::tr("Ease in"), true, false);
    addLevel(KeyMenu::tr("Ease out"), false, true);
    addLevel(KeyMenu::tr("Ease in and out"), true, true);
    menu.addSeparator();
}

void addOutside(QMenu& menu, Document& document, const Track& track)
{
    const std::array names{KeyMenu::tr("Hold"), KeyMenu::tr("Repeat"), KeyMenu::tr("Back and forth")};
    for (const bool isAfter : {false, true}) {
        QMenu* sides =
            menu.addMenu(isAfter ? KeyMenu::tr("After the last key frame") : KeyMenu::tr("Before the first key frame"));
        for (std::size_t i = 0; i < names.size(); ++i) {
            const auto how = static_cast<Extrapolation>(i);
            QAction* action = sides->addAction(names[i], &document, [&document, how, isAfter, track] {
                setExtrapolation(document, *track.parameter, isAfter ? track.before : how, isAfter ? how : track.after);
            });
            action->setCheckable(true);
            action->setChecked(how == (isAfter ? track.after : track.before));
        }
    }
    menu.addSeparator();
}

} // namespace

void fillKeyMenu(QMenu& menu, Document& document, KeySelection& selection, const Track* track)
{
    menu.setObjectName(QStringLiteral("keyMenu"));
    addEases(menu, document, selection);
    if (track != nullptr) {
        addOutside(menu, document, *track);
        addKeyMends(menu, document, *track);
        addKeyTable(menu, document, *track, askInDialog, menu.parentWidget());
    }
    const bool isAny = !selection.keys().empty();
    menu.addAction(KeyMenu::tr("Copy"), &selection, [&] { copyKeys(document, selection.keys()); })->setEnabled(isAny);
    menu.addAction(
            KeyMenu::tr("Paste at the time that is shown"), &selection, [&] { selection.select(pasteKeys(document)); })
        ->setEnabled(hasCopiedKeys());
    menu.addAction(KeyMenu::tr("Remove"), &selection, [&] { removeKeys(document, selection.keys()); })
        ->setEnabled(isAny);
}

} // namespace fumage::ui
