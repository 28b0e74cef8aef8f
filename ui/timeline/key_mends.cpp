#include "ui/timeline/key_mends.h"

#include "ui/document/key_edits.h"

#include <QCoreApplication>
#include <QMenu>

#include <array>

namespace fumage::ui {

namespace {

struct KeyMends {
    Q_DECLARE_TR_FUNCTIONS(KeyMends)
};

} // namespace

QString keyFaultsTold(const Track& track, const Timeline& timeline)
{
    const std::array said{KeyMends::tr("It does not end as it begins, so the loop jumps there."),
        KeyMends::tr("It has key frames after the end of the timeline."),
        KeyMends::tr("It changes at once at a held key frame, so what it drives changes its pace with a jerk.")};
    QString told;
    for (const KeyFault fault : keyFaults(track, timeline)) {
        told += said[static_cast<std::size_t>(fault)] + QLatin1Char('\n');
    }
    return told;
}

void addKeyMends(QMenu& menu, Document& document, const Track& track)
{
    const std::array names{
        KeyMends::tr("Make periodic"), KeyMends::tr("Move into the timeline"), KeyMends::tr("Smooth the jumps")};
    for (const KeyFault fault : keyFaults(track, document.scene().timeline)) {
        menu.addAction(names[static_cast<std::size_t>(fault)], &document,
            [&document, parameter = track.parameter, fault] { mendKeys(document, *parameter, fault); });
    }
    menu.addSeparator();
}

} // namespace fumage::ui
