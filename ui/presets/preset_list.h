#pragma once

#include "ui/presets/thumbnailer.h"

#include "core/preset/library.h"

#include <QListWidget>

#include <vector>

namespace fumage::ui {

/// Pictures of presets with their names: the built-in ones, the favourites and the user's own.
class PresetList : public QListWidget {
    Q_OBJECT

public:
    explicit PresetList(int edge, QWidget* parent = nullptr);

    /// Reads both folders anew and renders every thumbnail.
    void reload();
    /// @param words empty: all; favourites are the ids that come first and have a star
    void filter(const QString& words, bool onlyFavourites);
    void setFavourites(const QStringList& ids);

    [[nodiscard]] const LibraryEntry* entryOf(const QListWidgetItem* item) const;
    /// The preset of an item as it was read; nothing where its file is broken.
    [[nodiscard]] const Preset* presetOf(const QListWidgetItem* item) const;
    [[nodiscard]] QString idOf(const QListWidgetItem* item) const;

    /// What is dragged out of the list: an id that presetOfId() knows.
    static QString mimeType();
    [[nodiscard]] const Preset* presetOfId(const QString& id) const;

signals:
    void chosen(const fumage::Preset& preset);

protected:
    QMimeData* mimeData(const QList<QListWidgetItem*>& items) const override;
    void showEvent(QShowEvent* event) override;

private:
    struct Shelf {
        LibraryEntry entry;
        Preset preset;
        bool broken = false;
    };
    [[nodiscard]] const Shelf* shelfOf(const QListWidgetItem* item) const;
    void addEntry(const LibraryEntry& entry);
    void receive(const QString& id, const QImage& image);
    void label(QListWidgetItem& item) const;

    Thumbnailer m_thumbnailer;
    std::vector<Shelf> m_shelves; ///< one an item, found by its index in the item's data
    QStringList m_favourites;
    int m_edge;
    bool m_loaded = false;
};

} // namespace fumage::ui
