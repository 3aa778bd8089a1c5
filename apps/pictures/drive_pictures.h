// The pictures of drives, the same for every face.
#ifndef APPS_PICTURES_DRIVE_PICTURES_H_
#define APPS_PICTURES_DRIVE_PICTURES_H_

#include <string>

#include "apps/answers/drive_answer.h"

namespace tautline {

/// As SVG: the candidates, where they were asked for and the robot came so far; else the drive.
std::string DrawAnswer(const Scene& scene, const DriveQuestion& question, const DriveAnswer& answer);

/// The drive as a film; where it could not begin, a picture that stands still.
std::string AnimateAnswer(const Scene& scene, const DriveQuestion& question, const DriveAnswer& answer);

}  // namespace tautline

#endif  // APPS_PICTURES_DRIVE_PICTURES_H_
