#include "state_text.h"

#include <QCoreApplication>

namespace boomwatch {
namespace {

class StateText {
  Q_DECLARE_TR_FUNCTIONS(StateText)
};

bool playing(const SourceStatus& status) {
  return status.player && status.player->state == PlayState::Playing;
}

QString frameText(const PlayerStatus& player) {
  if (!player.position) return StateText::tr("no frame yet");
  const QString frame = QString::number(*player.position + 1);
  if (!player.count) return StateText::tr("this is frame %1").arg(frame);
  return StateText::tr("this is frame %1 of %2").arg(frame).arg(*player.count);
}

QString playerSentence(const SourceStatus& status) {
  const PlayerStatus& player = *status.player;
  switch (player.state) {
    case PlayState::Playing:
      return player.live ? StateText::tr("Live: %1").arg(status.address)
                         : StateText::tr("Recording: %1").arg(status.address);
    case PlayState::Paused:
      return StateText::tr("Paused: %1. The picture is not live.").arg(frameText(player));
    case PlayState::Ended:
      return StateText::tr("End of the recording: %1. The picture is not live.")
          .arg(frameText(player));
    case PlayState::Lost:
      return StateText::tr("%1 is lost. Press Play to open it again.").arg(status.address);
  }
  return {};
}

}  // namespace

QString barCaption(const SourceStatus& status) {
  if (!status.player) {
    return status.opening.isEmpty() ? StateText::tr("NO SOURCE") : StateText::tr("OPENING");
  }
  switch (status.player->state) {
    case PlayState::Playing:
      return status.player->live ? StateText::tr("LIVE") : StateText::tr("RECORDING");
    case PlayState::Paused:
      return StateText::tr("PAUSED");
    case PlayState::Ended:
      return StateText::tr("END");
    case PlayState::Lost:
      return StateText::tr("LOST");
  }
  return {};
}

QString stateSentence(const SourceStatus& status, bool rebuilding) {
  if (!status.opening.isEmpty()) {
    return status.player ? StateText::tr("Opening %1... Until then %2 continues.")
                               .arg(status.opening, status.address)
                         : StateText::tr("Opening %1...").arg(status.opening);
  }
  if (!status.player) {
    return StateText::tr(
        "No source is open. Choose one in the Source menu, or drop a recording here.");
  }
  if (!rebuilding) return playerSentence(status);
  return playing(status) ? StateText::tr("Rebuilding the model...")
                         : StateText::tr("The model will be rebuilt with the next frame. ") +
                               playerSentence(status);
}

}  // namespace boomwatch
