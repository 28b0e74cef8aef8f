#include "ui/presets/preset_browser.h"

#include "ui/document/text.h"
#include "ui/theme/icons.h"
#include "ui/widgets/message_box.h"

#include <QFile>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

namespace fumage::ui {

namespace {

constexpr int kThumbnail = 104;

} // namespace

PresetBrowser::PresetBrowser(QWidget* parent)
    : QWidget(parent)
    , m_search(new QLineEdit(this))
    , m_onlyFavourites(
          makeIconButton(this, QStringLiteral("onlyFavourites"), QStringLiteral("star"), tr("Favourites only")))
    , m_list(new PresetList(kThumbnail, this))
{
    setObjectName(QStringLiteral("presetBrowser"));
    m_search->setObjectName(QStringLiteral("presetSearch"));
    m_search->setAccessibleName(tr("Search presets"));
    m_search->setPlaceholderText(tr("Search presets"));
    m_search->setClearButtonEnabled(true);
    m_onlyFavourites->setCheckable(true);
    m_list->setContextMenuPolicy(Qt::CustomContextMenu);
    m_list->setFrameShape(QFrame::NoFrame);
    auto* top = new QHBoxLayout;
    top->addWidget(m_search, 1);
    top->addWidget(m_onlyFavourites);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    layout->addLayout(top);
    layout->addWidget(m_list, 1);
    connect(m_search, &QLineEdit::textChanged, this, &PresetBrowser::filter);
    connect(m_onlyFavourites, &QToolButton::toggled, this, &PresetBrowser::filter);
    connect(m_list, &PresetList::chosen, this, &PresetBrowser::opened);
    connect(m_list, &QWidget::customContextMenuRequested, this, &PresetBrowser::showMenu);
}

void PresetBrowser::setFavourites(const QStringList& ids)
{
    m_favourites = ids;
    m_list->setFavourites(ids);
    filter();
}

void PresetBrowser::filter()
{
    m_list->filter(m_search->text(), m_onlyFavourites->isChecked());
}

void PresetBrowser::remove(const QString& path)
{
    if (!MessageBox::ask(this, tr("Delete the preset"), tr("Delete “%1”? The file goes to the trash.").arg(path))) {
        return;
    }
    if (!QFile::moveToTrash(path)) {
        MessageBox::warn(
            this, tr("Delete the preset"), tr("“%1” cannot be moved to the trash. Delete the file by hand.").arg(path));
    }
    m_list->reload();
}

void PresetBrowser::showMenu(const QPoint& at)
{
    const QListWidgetItem* item = m_list->itemAt(at);
    const Preset* preset = m_list->presetOf(item);
    const LibraryEntry* entry = m_list->entryOf(item);
    if (entry == nullptr) {
        return;
    }
    QMenu menu(this);
    if (preset != nullptr) {
        // Copies: while the menu is open the list may be filled anew.
        menu.addAction(tr("Open"), this, [this, preset = *preset] { emit opened(preset); });
        menu.addAction(tr("Apply to this document"), this, [this, preset = *preset] { emit applied(preset); });
        menu.addAction(tr("Add its layers"), this, [this, preset = *preset] { emit layersWanted(preset); });
        const QString id = m_list->idOf(item);
        const bool favourite = m_favourites.contains(id);
        menu.addAction(favourite ? tr("No longer a favourite") : tr("Make a favourite"), this,
            [this, id, favourite] { emit favouriteChanged(id, !favourite); });
    }
    if (!entry->path.empty()) {
        menu.addSeparator();
        menu.addAction(tr("Delete…"), this, [this, path = fromPath(entry->path)] { remove(path); });
    }
    menu.exec(m_list->viewport()->mapToGlobal(at));
}

} // namespace fumage::ui
