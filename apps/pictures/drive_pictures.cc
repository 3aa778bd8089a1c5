#include "apps/pictures/drive_pictures.h"

#include "tautline/draw/draw_drive.h"
#include "tautline/draw/draw_untangling.h"

namespace tautline {
namespace {

DrivePicture PictureOf(const DriveQuestion& question, const DriveAnswer& answer) {
  return {.frames = answer.trace,
          .contacts = answer.contacts,
          .goals = answer.goals,
          .robot_radius_m = question.options.robot.radius_m,
          .explanation = answer.explanation};
}

}  // namespace

std::string DrawAnswer(const Scene& scene, const DriveQuestion& question, const DriveAnswer& answer) {
  if (answer.candidates) return DrawUntangling(scene, *answer.grid, *answer.candidates);
  return DrawDrive(scene, PictureOf(question, answer));
}

std::string AnimateAnswer(const Scene& scene, const DriveQuestion& question, const DriveAnswer& answer) {
  return AnimateDrive(scene, PictureOf(question, answer));
}

}  // namespace tautline
