#pragma once

#include "ui/presets/loop_player.h"
#include "ui/presets/thumbnailer.h"

#include "core/preset/preset.h"

#include <QAbstractButton>

#include <optional>

namespace fumage::ui {

/// A preset as a large card that moves by itself, with its name and what is said about it; a click chooses it. Plays
/// only while it is seen.
class SceneCard : public QAbstractButton {
    Q_OBJECT

public:
    explicit SceneCard(QWidget* parent = nullptr);

    /// @param name,description in the language of the user
    void setPreset(const Preset& preset, const QString& name, const QString& description);
    /// Null: none is there yet.
    [[nodiscard]] const Preset* preset() const { return m_preset ? &*m_preset : nullptr; }
    void setPlays(bool plays);
    [[nodiscard]] const LoopPlayer& player() const { return m_player; }

    [[nodiscard]] QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void follow();

    std::optional<Preset> m_preset;
    QString m_description;
    QImage m_still;
    bool m_plays = true;
    Thumbnailer m_thumbnailer;
    LoopPlayer m_player;
};

} // namespace fumage::ui
