mkgrid --polygon nowhere.xy
