#include "ui/theme/svg_icon.h"

#include "ui/theme/svg_drawing.h"

#include <QFile>
#include <QGuiApplication>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>

namespace fumage::ui {

namespace {

class SvgIconEngine : public QIconEngine {
public:
    explicit SvgIconEngine(QString file)
        : m_file(std::move(file))
    {
    }

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override
    {
        const qreal ratio = painter->device()->devicePixelRatioF();
        painter->drawPixmap(rect, rendered(rect.size() * ratio, mode, state));
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
    {
        return rendered(size, mode, state);
    }
    QPixmap scaledPixmap(const QSize& size, QIcon::Mode mode, QIcon::State state, qreal) override
    {
        return rendered(size, mode, state);
    }
    /// What a style sheet names comes here.
    void addFile(const QString& file, const QSize&, QIcon::Mode, QIcon::State) override { m_file = file; }
    bool isNull() override { return m_file.isEmpty(); }
    QIconEngine* clone() const override { return new SvgIconEngine(m_file); }

private:
    [[nodiscard]] QPixmap rendered(const QSize& size, QIcon::Mode mode, QIcon::State state) const
    {
        if (size.isEmpty()) { // of a button that is squeezed to nothing
            return {};
        }
        const QPalette palette = QGuiApplication::palette();
        QColor colour =
            palette.color(mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active, QPalette::ButtonText);
        if (state == QIcon::On) {
            colour = palette.color(QPalette::Link);
        }
        const QString key = QStringLiteral("fumage/%1/%2x%3/%4")
                                .arg(m_file)
                                .arg(size.width())
                                .arg(size.height())
                                .arg(colour.name(QColor::HexArgb));
        QPixmap pixmap;
        if (QPixmapCache::find(key, &pixmap)) {
            return pixmap;
        }
        QFile file(m_file);
        if (!file.open(QIODevice::ReadOnly)) {
            return {};
        }
        QByteArray svg = file.readAll();
        svg.replace("currentColor", colour.name().toLatin1());
        pixmap = QPixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        static_cast<void>(drawSvg(painter, svg, pixmap.rect())); // a test reads every icon
        painter.end();
        QPixmapCache::insert(key, pixmap);
        return pixmap;
    }

    QString m_file;
};

} // namespace

QIconEngine* makeSvgIconEngine(const QString& file)
{
    return new SvgIconEngine(file);
}

} // namespace fumage::ui
