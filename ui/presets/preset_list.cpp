#include "ui/presets/preset_list.h"

#include "ui/document/layer_clipboard.h"
#include "ui/document/text.h"
#include "ui/widgets/plain_text.h"

#include <algorithm>

#include <QCoreApplication>
#include <QMimeData>
#include <QPainter>
#include <QStyledItemDelegate>
#include <QTimer>

namespace fumage::ui {

namespace {

constexpr int kShelfRole = Qt::UserRole;

QString idOfEntry(const LibraryEntry& entry)
{
    return entry.path.empty() ? toQString(entry.id) : fromPath(entry.path);
}

/// A text of a preset; those of built-in ones in the language of the user.
QString textOf(const LibraryPreset& shelf, const std::string& text)
{
    return shelf.entry.path.empty() && !text.empty() ? QCoreApplication::translate("Presets", text.c_str())
                                                     : toQString(text);
}

QString nameOf(const LibraryPreset& shelf)
{
    return shelf.preset.name.empty() ? toQString(shelf.entry.id) : textOf(shelf, shelf.preset.name);
}

/// Draws the picture that plays in place of the one that stands still.
class PlayingDelegate : public QStyledItemDelegate {
public:
    explicit PlayingDelegate(PresetList& list)
        : QStyledItemDelegate(&list)
        , m_list(list)
    {
    }

protected:
    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override
    {
        QStyledItemDelegate::initStyleOption(option, index);
        const LoopPlayer& player = m_list.player();
        const QListWidgetItem* item = m_list.item(index.row());
        if (player.name().isEmpty() || item == nullptr || m_list.idOf(item) != player.name()) {
            return;
        }
        if (const QImage frame = player.frame(); !frame.isNull()) {
            QPixmap pixmap = QPixmap::fromImage(frame);
            pixmap.setDevicePixelRatio(m_list.devicePixelRatioF());
            option->icon = QIcon(pixmap);
        }
    }

private:
    const PresetList& m_list;
};

} // namespace

PresetList::PresetList(int edge, QWidget* parent)
    : QListWidget(parent)
    , m_thumbnailer(ThumbnailStore(ThumbnailStore::usualFolder()))
    , m_player(ThumbnailStore(ThumbnailStore::usualFolder()))
    , m_edge(edge)
{
    setObjectName(QStringLiteral("presetList"));
    setAccessibleName(tr("Presets"));
    setViewMode(QListView::IconMode);
    setResizeMode(QListView::Adjust);
    setMovement(QListView::Static);
    setIconSize({edge, edge});
    setGridSize({edge + 16, edge + 36});
    setWordWrap(true);
    setUniformItemSizes(true);
    setDragEnabled(true);
    setSpacing(2);
    connect(
        &m_reader, &LibraryReader::found, this, qOverload<const std::vector<LibraryPreset>&, bool>(&PresetList::add));
    connect(&m_thumbnailer, &Thumbnailer::ready, this, &PresetList::receive);
    setItemDelegate(new PlayingDelegate(*this));
    setMouseTracking(true);
    connect(this, &QListWidget::itemEntered, this, &PresetList::play);
    connect(this, &QListWidget::viewportEntered, this, [this] { play(nullptr); });
    connect(this, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
        if (hasFocus()) {
            play(item);
        }
    });
    connect(&m_player, &LoopPlayer::moved, this, [this](const QString& id) {
        if (const QListWidgetItem* item = m_items.value(id)) {
            update(indexFromItem(item));
        }
    });
    connect(this, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) {
        if (const Preset* preset = presetOf(item)) {
            const Preset copy = *preset; // the list may be filled anew while somebody answers a question
            emit chosen(copy);
        }
    });
}

void PresetList::showEvent(QShowEvent* event)
{
    QListWidget::showEvent(event);
    if (!m_loaded) {
        m_loaded = true;
        // The smoke itself comes first.
        constexpr int kLaterMs = 400;
        QTimer::singleShot(kLaterMs, this, &PresetList::reload);
    }
}

void PresetList::hideEvent(QHideEvent* event)
{
    QListWidget::hideEvent(event);
    play(nullptr);
}

void PresetList::focusOutEvent(QFocusEvent* event)
{
    QListWidget::focusOutEvent(event);
    if (!viewport()->underMouse()) {
        play(nullptr);
    }
}

bool PresetList::viewportEvent(QEvent* event)
{
    if (event->type() == QEvent::Leave) {
        play(nullptr);
    }
    return QListWidget::viewportEvent(event);
}

void PresetList::setPlays(bool plays)
{
    m_plays = plays;
    if (!plays) {
        play(nullptr);
    }
}

void PresetList::play(const QListWidgetItem* item)
{
    const Preset* preset = presetOf(item);
    if (!m_plays || preset == nullptr || !isVisible()) {
        m_player.stop();
    } else {
        m_player.start(idOf(item), preset->scene, pixels());
    }
}

void PresetList::reload()
{
    m_loaded = true;
    m_reader.read();
}

void PresetList::add(const std::vector<LibraryPreset>& presets, bool first)
{
    if (first) {
        m_thumbnailer.clear();
        m_player.stop();
        clear();
        m_shelves.clear();
        m_items.clear();
    }
    for (const LibraryPreset& preset : presets) {
        add(preset);
    }
}

void PresetList::add(const LibraryPreset& shelf)
{
    const Preset& preset = shelf.preset;
    const QString id = idOfEntry(shelf.entry);
    auto* item = new QListWidgetItem;
    item->setData(kShelfRole, static_cast<int>(m_shelves.size()));
    item->setSizeHint(gridSize());
    m_shelves.push_back(shelf);
    insertItem(rowFor(id), item);
    m_items.insert(id, item);
    label(*item);
    item->setHidden(!isWanted(*item));
    if (!shelf.trouble.isEmpty()) {
        item->setToolTip(plainToolTip(shelf.trouble));
        item->setFlags(item->flags() & ~Qt::ItemIsEnabled);
        return;
    }
    constexpr qsizetype kLongestTip = 400;
    const QString description = shortened(textOf(shelf, preset.description), kLongestTip);
    item->setToolTip(titledToolTip(shortened(nameOf(shelf)), description));
    QPixmap blank(m_edge, m_edge);
    blank.fill(QColor(30, 34, 40));
    item->setIcon(blank);
    m_thumbnailer.request(id, preset.scene, pixels());
    emit presetRead(id);
}

int PresetList::rowFor(const QString& id) const
{
    if (!m_first.contains(id)) {
        return count();
    }
    const auto place = m_first.indexOf(id);
    int row = 0;
    while (row < count() && m_first.contains(idOf(item(row))) && m_first.indexOf(idOf(item(row))) < place) {
        ++row;
    }
    return row;
}

void PresetList::label(QListWidgetItem& item) const
{
    const LibraryPreset* shelf = shelfOf(&item);
    const QString name = shortened(nameOf(*shelf));
    const bool favourite = m_favourites.contains(idOf(&item));
    item.setText((favourite ? QStringLiteral("★ ") : QString()) + name
        + (shelf->trouble.isEmpty() ? QString() : tr(" (broken)")));
}

void PresetList::receive(const QString& id, const QImage& image)
{
    if (QListWidgetItem* item = m_items.value(id)) {
        QPixmap pixmap = QPixmap::fromImage(image);
        pixmap.setDevicePixelRatio(devicePixelRatioF());
        item->setIcon(pixmap);
    }
}

const LibraryPreset* PresetList::shelfOf(const QListWidgetItem* item) const
{
    return &m_shelves[static_cast<std::size_t>(item->data(kShelfRole).toInt())];
}

const LibraryEntry* PresetList::entryOf(const QListWidgetItem* item) const
{
    return item == nullptr ? nullptr : &shelfOf(item)->entry;
}

const Preset* PresetList::presetOf(const QListWidgetItem* item) const
{
    return item == nullptr || !shelfOf(item)->trouble.isEmpty() ? nullptr : &shelfOf(item)->preset;
}

QString PresetList::idOf(const QListWidgetItem* item) const
{
    return idOfEntry(shelfOf(item)->entry);
}

QString PresetList::descriptionOf(const QListWidgetItem* item) const
{
    const LibraryPreset& shelf = *shelfOf(item);
    return textOf(shelf, shelf.preset.description);
}

const Preset* PresetList::presetOfId(const QString& id) const
{
    return presetOf(m_items.value(id));
}

void PresetList::setFavourites(const QStringList& ids)
{
    m_favourites = ids;
    for (int i = 0; i < count(); ++i) {
        label(*item(i));
    }
}

void PresetList::filter(const QString& words, bool onlyFavourites)
{
    m_words = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    m_onlyFavourites = onlyFavourites;
    for (int i = 0; i < count(); ++i) {
        item(i)->setHidden(!isWanted(*item(i)));
    }
    setAccessibleDescription(emptyRemark());
    viewport()->update();
}

void PresetList::paintEvent(QPaintEvent* event)
{
    QListWidget::paintEvent(event);
    const QString remark = emptyRemark();
    if (!remark.isEmpty()) {
        constexpr int kMargin = 12;
        QPainter painter(viewport());
        painter.setPen(palette().color(QPalette::PlaceholderText));
        painter.drawText(viewport()->rect().adjusted(kMargin, kMargin, -kMargin, -kMargin),
            Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, remark);
    }
}

QString PresetList::emptyRemark() const
{
    for (int i = 0; i < count(); ++i) {
        if (!item(i)->isHidden()) {
            return {};
        }
    }
    if (count() == 0) {
        return {};
    }
    if (m_onlyFavourites && m_favourites.isEmpty()) {
        return tr("There are no favourites yet: the menu of a preset makes it one.");
    }
    return tr("No preset matches “%1”.").arg(shortened(m_words.join(QLatin1Char(' '))));
}

bool PresetList::isWanted(const QListWidgetItem& item) const
{
    const LibraryPreset& shelf = *shelfOf(&item);
    const QString text = item.text() + QLatin1Char(' ') + textOf(shelf, shelf.preset.description) + QLatin1Char(' ')
        + toQString(shelf.preset.name + ' ' + shelf.preset.description);
    const bool found = std::all_of(
        m_words.begin(), m_words.end(), [&](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
    return found && (!m_onlyFavourites || m_favourites.contains(idOf(&item)));
}

QString PresetList::mimeType()
{
    return QStringLiteral("application/x-fumage-preset-id");
}

QMimeData* PresetList::mimeData(const QList<QListWidgetItem*>& items) const
{
    auto* dragged = new QMimeData;
    if (!items.isEmpty()) {
        dragged->setData(mimeType(), idOf(items.constFirst()).toUtf8());
        if (const Preset* preset = presetOf(items.constFirst())) {
            addLayers(*dragged, *preset);
        }
    }
    return dragged;
}

} // namespace fumage::ui
