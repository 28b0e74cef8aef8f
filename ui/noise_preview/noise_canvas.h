#pragma once

#include "ui/noise_preview/noise_picture.h"

#include <QWidget>

namespace fumage::ui {

/// A tile of noise that can be zoomed, moved and tiled, with the line whose profile is plotted.
class NoiseCanvas : public QWidget {
    Q_OBJECT

public:
    explicit NoiseCanvas(QWidget* parent = nullptr);

    void show(const NoisePicturePtr& picture);
    void setTiled(bool tiled);
    void setLineShown(bool shown);
    [[nodiscard]] double line() const { return m_line; } ///< height of the line in the tile, from its top, in [0, 1)

    QSize minimumSizeHint() const override { return {96, 64}; }
    QSize sizeHint() const override { return {260, 260}; }

signals:
    void lineMoved();

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    bool event(QEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;

private:
    [[nodiscard]] double tileEdge() const; ///< of a tile on the screen, pixels
    [[nodiscard]] QPointF corner() const; ///< of the first tile

    NoisePicturePtr m_picture;
    bool m_tiled = false;
    bool m_lineShown = true;
    double m_zoom = 1.0;
    QPointF m_offset;
    QPointF m_mouse;
    double m_line = 0.5;
    Qt::MouseButton m_button = Qt::NoButton; ///< that drags
    struct {
        double line = 0.0;
        QPointF offset;
    } m_before; ///< the drag
};

/// Figure 4 of the 2012 model: the profile of the noise along a line, with amplitude and wavelength marked; and its
/// histogram.
class NoisePlots : public QWidget {
    Q_OBJECT

public:
    explicit NoisePlots(QWidget* parent = nullptr);

    void show(const NoisePicturePtr& picture, double line, double wavelength);
    void setProfileShown(bool shown);

    QSize sizeHint() const override { return {260, 96}; }
    QSize minimumSizeHint() const override { return {96, 32}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintProfile(QPainter& painter, const QRectF& area) const;
    void paintHistogram(QPainter& painter, const QRectF& area) const;

    NoisePicturePtr m_picture;
    double m_line = 0.5;
    double m_wavelength = 1.0;
    bool m_profileShown = true;
};

} // namespace fumage::ui
