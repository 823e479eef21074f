// SPDX-License-Identifier: MIT
// One colour per ten degrees of a triangle's smallest angle, for the model and for the histogram:
// 50 to 60 degrees is as good as it gets.

export const angleColors = ['#9f1d35', '#d1495b', '#ee9b5f', '#f2d492', '#9ccfb4', '#2a9d8f'];
