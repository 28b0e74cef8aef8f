#pragma once

#include "ui/presets/library_reader.h"
#include "ui/presets/loop_player.h"
#include "ui/presets/thumbnailer.h"

#include <QHash>
#include <QListWidget>

#include <vector>

namespace fumage::ui {

/// Pictures of presets with their names: the built-in ones, the favourites and the user's own.
class PresetList : public QListWidget {
    Q_OBJECT

public:
    explicit PresetList(int edge, QWidget* parent = nullptr);

    /// Reads the library anew; the list is filled as it is read.
    void reload();
    /// @param words empty: all; favourites are the ids that come first and have a star
    void filter(const QString& words, bool onlyFavourites);
    void setFavourites(const QStringList& ids);
    /// Ids that come before all others, in this order; for a list that is empty yet.
    void setFirst(const QStringList& ids) { m_first = ids; }
    /// Whether the preset under the pointer plays, or the one that the keyboard is on.
    void setPlays(bool plays);
    [[nodiscard]] const LoopPlayer& player() const { return m_player; }

    [[nodiscard]] const LibraryEntry* entryOf(const QListWidgetItem* item) const;
    /// The preset of an item as it was read; nothing where its file is broken.
    [[nodiscard]] const Preset* presetOf(const QListWidgetItem* item) const;
    [[nodiscard]] QString idOf(const QListWidgetItem* item) const;
    /// What is said about a preset, in the language of the user where it is built in.
    [[nodiscard]] QString descriptionOf(const QListWidgetItem* item) const;
    [[nodiscard]] QListWidgetItem* itemOfId(const QString& id) const { return m_items.value(id); }

    /// What is dragged out of the list: an id that presetOfId() knows; beside it the preset itself, for lists of
    /// layers.
    static QString mimeType();
    [[nodiscard]] const Preset* presetOfId(const QString& id) const;

signals:
    void chosen(const fumage::Preset& preset);
    /// It is in the list, with its preset.
    void presetRead(const QString& id);

protected:
    QMimeData* mimeData(const QList<QListWidgetItem*>& items) const override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    bool viewportEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] const LibraryPreset* shelfOf(const QListWidgetItem* item) const;
    /// What is said where nothing is wanted.
    [[nodiscard]] QString emptyRemark() const;
    [[nodiscard]] bool isWanted(const QListWidgetItem& item) const;
    void add(const std::vector<LibraryPreset>& presets, bool first);
    void add(const LibraryPreset& preset);
    void receive(const QString& id, const QImage& image);
    /// Where a preset of an id belongs among those that are there.
    [[nodiscard]] int rowFor(const QString& id) const;
    /// Plays an item; null: none.
    void play(const QListWidgetItem* item);
    [[nodiscard]] int pixels() const { return static_cast<int>(m_edge * devicePixelRatioF()); }
    void label(QListWidgetItem& item) const;

    LibraryReader m_reader;
    Thumbnailer m_thumbnailer;
    LoopPlayer m_player;
    QStringList m_first;
    bool m_plays = true;
    std::vector<LibraryPreset> m_shelves; ///< one an item, found by its index in the item's data
    QHash<QString, QListWidgetItem*> m_items; ///< by id
    QStringList m_words;
    QStringList m_favourites;
    bool m_onlyFavourites = false;
    int m_edge;
    bool m_loaded = false;
};

} // namespace fumage::ui
