#pragma once

#include "ui/presets/preset_list.h"

#include <QWidget>

class QLineEdit;
class QToolButton;

namespace fumage::ui {

/// The presets with search and favourites.
class PresetBrowser : public QWidget {
    Q_OBJECT

public:
    explicit PresetBrowser(QWidget* parent = nullptr);

    [[nodiscard]] PresetList& list() const { return *m_list; }
    void setFavourites(const QStringList& ids);

signals:
    /// Open it as a document of its own.
    void opened(const fumage::Preset& preset);
    /// Put its effect into the present document.
    void applied(const fumage::Preset& preset);
    /// Put its layers beside those of the present document.
    void layersWanted(const fumage::Preset& preset);
    void favouriteChanged(const QString& id, bool favourite);

private:
    void filter();
    void showMenu(const QPoint& at);
    void remove(const QString& path);

    QLineEdit* m_search;
    QToolButton* m_onlyFavourites;
    PresetList* m_list;
    QStringList m_favourites;
};

} // namespace fumage::ui
